#include "sylph_core/control/motion_watch.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace sylph {
namespace {

constexpr double kPeriod_s = 0.01;

/// Offers motion at constant velocities [m/s].
void offerFor(MotionWatch& watch, double duration_s, const Vector2& commanded_mps,
              const Vector2& measured_mps) {
  for (double time_s = 0.0; time_s < duration_s; time_s += kPeriod_s) {
    watch.offer(kPeriod_s * commanded_mps, kPeriod_s * measured_mps, kPeriod_s);
  }
}

TEST(MotionWatchTest, ABaseThatFollowsOrLagsIsNoProblem) {
  MotionWatch watch({});
  offerFor(watch, 2.0, {0.25, 0.0}, {0.24, 0.01});
  offerFor(watch, 2.0, {0.25, 0.0}, {0.05, 0.0});
  offerFor(watch, 2.0, {0.0, 0.0}, {0.0, 0.02});
  EXPECT_FALSE(watch.problem());
  EXPECT_FALSE(watch.isUnanswered());
}

TEST(MotionWatchTest, MotionAgainstOrBesideTheCommandsIsAProblemWithinTheWindow) {
  for (const Vector2 measured_mps : {Vector2{-0.25, 0.0}, Vector2{0.0, 0.25}, Vector2{0.6, 0.0}}) {
    MotionWatch watch({});
    offerFor(watch, 0.4, {0.25, 0.0}, measured_mps);
    ASSERT_TRUE(watch.problem());
    EXPECT_NE(std::string::npos, watch.problem()->find("exchanged or turned")) << *watch.problem();
  }
}

TEST(MotionWatchTest, APoseThatSlidesWhileTheRobotStandsIsAProblem) {
  MotionWatch watch({});
  offerFor(watch, 0.4, {}, {0.1, 0.0});
  EXPECT_TRUE(watch.problem());
}

TEST(MotionWatchTest, ABaseThatIsStuckForAWhileCreepsAndGoesOn) {
  MotionWatch watch({});
  offerFor(watch, 0.3, {0.25, 0.0}, {});
  EXPECT_TRUE(watch.isUnanswered());
  offerFor(watch, 2.5, {0.02, 0.0}, {});
  EXPECT_TRUE(watch.isUnanswered());
  EXPECT_FALSE(watch.problem());
  offerFor(watch, 1.0, {0.02, 0.0}, {0.02, 0.0});
  EXPECT_FALSE(watch.isUnanswered());
}

TEST(MotionWatchTest, ABaseThatNeverAnswersIsAProblemUntilTheOperatorHasLooked) {
  MotionWatch watch({});
  offerFor(watch, 0.3, {0.25, 0.0}, {});
  offerFor(watch, 3.1, {0.02, 0.0}, {});
  ASSERT_TRUE(watch.problem());
  EXPECT_NE(std::string::npos, watch.problem()->find("does not follow the commands"));
  watch.pause();
  EXPECT_TRUE(watch.problem());
  watch.confirm();
  EXPECT_FALSE(watch.problem());
  EXPECT_FALSE(watch.isUnanswered());
}

TEST(MotionWatchTest, RefusesOptionsOutOfBounds) {
  MotionWatchOptions options;
  options.least_answer = 1.5;
  EXPECT_THROW(MotionWatch{options}, std::invalid_argument);
}

}  // namespace
}  // namespace sylph
