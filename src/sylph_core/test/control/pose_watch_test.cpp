#include "sylph_core/control/pose_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace sylph {
namespace {

constexpr double kFrame_s = 1.0 / 120.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Feeds frames at 120 Hz, each 10 ms old when it arrives.
class Feed {
 public:
  explicit Feed(const PoseWatchOptions& options = {}) : watch(options) {}

  PoseVerdict frame(const Pose2d& pose) {
    now_s += kFrame_s;
    return offer({pose, now_s - 0.01, now_s - 0.01, now_s});
  }
  /// Of a robot that its commands have led by `driven_x_m` since it was seen.
  PoseVerdict offer(const TimedPose& pose) {
    Pose2d driven = watch.seen() ? watch.seen()->pose : Pose2d{};
    driven.x_m += driven_x_m;
    driven.yaw_rad += driven_yaw_rad;
    return watch.offer(pose, driven);
  }
  PoseVerdict frames(int count, const Pose2d& pose) {
    PoseVerdict verdict = PoseVerdict::Good;
    for (int i = 0; i < count; ++i) {
      verdict = frame(pose);
    }
    return verdict;
  }
  std::string problem() const { return watch.problem(now_s).value_or(""); }

  PoseWatch watch;
  double now_s = 100.0;
  double driven_x_m = 0.0;
  double driven_yaw_rad = 0.0;
};

TEST(PoseWatchTest, TrustsAPoseAfterSeveralGoodOnes) {
  Feed feed;
  EXPECT_EQ("no pose yet", feed.problem());
  feed.frames(2, {1.0, 1.0, 0.0});
  EXPECT_EQ("waiting for good poses", feed.problem());
  feed.frame({1.0, 1.0, 0.0});
  EXPECT_EQ("", feed.problem());
  EXPECT_NEAR(0.01, feed.watch.age(feed.now_s), 1e-9);
}

TEST(PoseWatchTest, SilenceMakesBlindAndPosesHeal) {
  Feed feed;
  feed.frames(5, {});
  feed.now_s += 0.08;
  EXPECT_EQ("", feed.problem());
  feed.now_s += 0.03;
  EXPECT_EQ("no good pose for 0.11 s", feed.problem());
  feed.frame({});
  EXPECT_EQ("waiting for good poses", feed.problem());
  feed.frames(2, {});
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, AnOldStampMakesBlindThoughPosesArrive) {
  Feed feed;
  for (int i = 0; i < 10; ++i) {
    feed.now_s += kFrame_s;
    feed.offer({{}, feed.now_s - 0.2, feed.now_s - 0.2, feed.now_s});
  }
  EXPECT_EQ("pose is 0.20 s old by its stamp", feed.problem());
}

TEST(PoseWatchTest, AStampFarAheadMakesBlind) {
  Feed feed;
  for (int i = 0; i < 10; ++i) {
    feed.now_s += kFrame_s;
    feed.offer({{}, feed.now_s + 0.3, feed.now_s + 0.3, feed.now_s});
  }
  EXPECT_NE(std::string::npos, feed.problem().find("check the clocks"));
}

TEST(PoseWatchTest, OneOutlierIsIgnored) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  EXPECT_EQ(PoseVerdict::Jumped, feed.frame({1.4, 1.0, 0.0}));
  EXPECT_EQ("", feed.problem());
  EXPECT_DOUBLE_EQ(1.0, feed.watch.last()->pose.x_m);
}

TEST(PoseWatchTest, NotFiniteMakesBlindAfterThreeFramesAndHeals) {
  Feed feed;
  feed.frames(5, {});
  EXPECT_EQ(PoseVerdict::NotFinite, feed.frames(3, {kNaN, 0.0, 0.0}));
  EXPECT_EQ("pose is not finite", feed.problem());
  feed.frames(3, {});
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, AYawFlipIsAJump) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.1});
  EXPECT_EQ(PoseVerdict::Jumped, feed.frames(3, {1.0, 1.0, 0.1 - M_PI}));
  EXPECT_EQ("pose jumped by 0.00 m and 180 deg", feed.problem());
}

TEST(PoseWatchTest, AFalsePlaceIsNotBelievedHoweverLongTheRobotWasUnseen) {
  for (const double gap_s : {0.05, 0.12, 0.3, 5.0, 3600.0}) {
    SCOPED_TRACE(gap_s);
    Feed feed;
    feed.frames(5, {1.0, 1.0, 0.0});
    feed.now_s += gap_s;
    EXPECT_EQ(PoseVerdict::Jumped, feed.frames(200, {1.0, 1.1, 0.0}));
    EXPECT_NE(std::string::npos, feed.problem().find("put the cameras right")) << feed.problem();
    EXPECT_DOUBLE_EQ(1.0, feed.watch.last()->pose.y_m);
    feed.watch.confirm();
    EXPECT_EQ(PoseVerdict::Recovered, feed.frame({1.0, 1.1, 0.0}));
    EXPECT_EQ("", feed.problem());
  }
}

TEST(PoseWatchTest, AfterAGapARobotIsWhereItWasDriven) {
  for (const double share : {0.75, 1.0, 1.25}) {  // slower ... faster than told
    SCOPED_TRACE(share);
    Feed feed;
    feed.frames(5, {1.0, 1.0, 0.0});
    feed.now_s += 0.3;
    feed.driven_x_m = 0.07;
    EXPECT_EQ(PoseVerdict::Good, feed.frame({1.0 + share * 0.07, 1.015, 0.0}));
  }
  for (const auto& [x_m, y_m] :
       {std::pair{1.14, 1.0}, std::pair{1.03, 1.0}, std::pair{1.07, 1.04}}) {
    SCOPED_TRACE(x_m);
    Feed feed;
    feed.frames(5, {1.0, 1.0, 0.0});
    feed.now_s += 0.3;
    feed.driven_x_m = 0.07;
    EXPECT_EQ(PoseVerdict::Jumped, feed.frame({x_m, y_m, 0.0}));
  }
}

TEST(PoseWatchTest, AJumpFromOneFrameToTheNextIsNotBelievedHoweverLongItLasts) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  EXPECT_EQ(PoseVerdict::Jumped, feed.frames(2000, {1.1, 1.0, 0.0}));
  EXPECT_NE(std::string::npos, feed.problem().find("put the cameras right"));
  // It goes on by itself when the poses return.
  EXPECT_EQ(PoseVerdict::Good, feed.frames(3, {1.0, 1.0, 0.0}));
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, AJumpAheadIsNotBelievedWhileARobotRampsToZero) {
  PoseWatch watch({});
  watch.offer(timedPose({}, 0.0, 0.0, 0.0), {});
  const Pose2d driven{0.045, 0.0, 0.0};  // from full speed to a standstill
  EXPECT_EQ(PoseVerdict::Good, watch.offer(timedPose({0.048, 0.0, 0.0}, 0.1, 0.0, 0.1), driven));
  PoseWatch other({});
  other.offer(timedPose({}, 0.0, 0.0, 0.0), {});
  EXPECT_EQ(PoseVerdict::Jumped, other.offer(timedPose({0.09, 0.0, 0.0}, 0.1, 0.0, 0.1), driven));
}

TEST(PoseWatchTest, AJumpIsBelievedWhenTheOperatorConfirmsIt) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  feed.frames(20, {1.1, 1.0, 0.0});
  feed.watch.confirm();
  EXPECT_EQ(PoseVerdict::Recovered, feed.frame({1.1, 1.0, 0.0}));
  EXPECT_EQ("", feed.problem());
  // The next one is not confirmed by that.
  EXPECT_EQ(PoseVerdict::Jumped, feed.frames(20, {1.2, 1.0, 0.0}));
}

TEST(PoseWatchTest, ARobotThatRolledOnWhileItsPoseWasFrozenIsFoundAgain) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  for (int i = 0; i < 60; ++i) {
    feed.frame({1.0, 1.0, 0.0});
    feed.watch.commanded(i < 30 ? 0.25 * kFrame_s : 0.0);
  }
  EXPECT_EQ("pose is frozen", feed.problem());
  feed.driven_x_m = 30 * 0.25 * kFrame_s;
  EXPECT_EQ(PoseVerdict::Good, feed.frame({1.08, 1.0, 0.0}));
  feed.driven_x_m = 0.0;
  EXPECT_EQ(PoseVerdict::Good, feed.frames(3, {1.08001, 1.0, 0.0}));
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, PosesThatJumpToAndFroAreNeverBelieved) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  for (int i = 0; i < 200; ++i) {
    feed.frame({i % 2 == 0 ? 1.3 : 1.6, 1.0, 0.0});
  }
  EXPECT_NE("", feed.problem());
  EXPECT_DOUBLE_EQ(1.0, feed.watch.last()->pose.x_m);
}

TEST(PoseWatchTest, ARobotAtFullSpeedNeverJumps) {
  Feed feed;
  feed.driven_x_m = 0.25 * kFrame_s;
  feed.driven_yaw_rad = 0.5 * kFrame_s;
  for (int i = 0; i < 600; ++i) {
    ASSERT_EQ(PoseVerdict::Good, feed.frame({0.25 * i * kFrame_s, 0.0, 0.5 * i * kFrame_s}));
  }
}

TEST(PoseWatchTest, RepeatedAndOutOfOrderFramesDoNotCount) {
  Feed feed;
  feed.frames(5, {});
  const TimedPose last = *feed.watch.last();
  EXPECT_EQ(PoseVerdict::Repeated, feed.offer(last));
  TimedPose older = last;
  older.stamp_s -= 0.1;
  EXPECT_EQ(PoseVerdict::Repeated, feed.offer(older));
  feed.now_s += 0.2;
  TimedPose repeated = last;
  repeated.received_s = feed.now_s;
  feed.offer(repeated);
  EXPECT_NE("", feed.problem());  // fresh messages with an old stamp are no fresh poses
}

TEST(PoseWatchTest, AMotionCaptureThatStartsAgainIsBelieved) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  double stamp_s = 0.0;
  PoseVerdict verdict = PoseVerdict::Good;
  for (int i = 0; i < 12; ++i) {
    feed.now_s += kFrame_s;
    stamp_s += kFrame_s;
    verdict = feed.offer({{1.0, 1.0, 0.0}, stamp_s, feed.now_s - 0.01, feed.now_s});
  }
  EXPECT_EQ(PoseVerdict::Recovered, verdict);
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, AFrozenPoseOfAMovingRobotMakesBlind) {
  Feed feed;
  feed.frames(5, {1.0, 1.0, 0.0});
  for (int i = 0; i < 30; ++i) {
    feed.frame({1.0, 1.0, 0.0});
    feed.watch.commanded(0.25 * kFrame_s);
  }
  EXPECT_EQ("pose is frozen", feed.problem());
  feed.frame({1.0001, 1.0, 0.0});
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, AStandingRobotMayHaveAPoseThatDoesNotChange) {
  Feed feed;
  feed.frames(1000, {1.0, 1.0, 0.0});
  EXPECT_EQ("", feed.problem());
}

TEST(PoseWatchTest, RefusesOptionsThatAreNotPositive) {
  PoseWatchOptions bad;
  bad.timeout_s = 0.0;
  EXPECT_THROW(PoseWatch{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace sylph
