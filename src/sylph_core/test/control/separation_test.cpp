#include "sylph_core/control/separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sylph {
namespace {

constexpr double kFrame = 1.0 / 120.0;

SeparationWatch watchOf(int robots, const SeparationLimits& limits = {}) {
  std::vector<Footprint> sizes(static_cast<std::size_t>(robots));
  for (Footprint& size : sizes) {
    size.length_m = 0.23;
    size.width_m = 0.20;
  }
  return {sizes, limits};
}

TEST(SeparationWatchTest, KnowsTheClosestPairNowAndEver) {
  SeparationWatch watch = watchOf(3);
  EXPECT_TRUE(std::isinf(watch.closest().gap_m));
  watch.update(0, {0.0, 0.0, 0.0}, 0.0);
  EXPECT_TRUE(std::isinf(watch.closest().gap_m)) << "one robot alone is far from everybody";
  watch.update(1, {0.3, 0.0, 0.0}, 0.0);
  watch.update(2, {5.0, 0.0, 0.0}, 0.0);
  EXPECT_EQ(0, watch.closest().robot_a);
  EXPECT_EQ(1, watch.closest().robot_b);
  EXPECT_NEAR(0.07, watch.closest().gap_m, 1e-12);
  watch.update(1, {4.6, 0.0, 0.0}, 1.0);
  EXPECT_EQ(2, watch.closest().robot_b);
  EXPECT_NEAR(0.17, watch.closest().gap_m, 1e-12);
  EXPECT_EQ(0, watch.closestEver().robot_a);
  EXPECT_NEAR(0.07, watch.closestEver().gap_m, 1e-12);
}

TEST(SeparationWatchTest, RobotsAtRestInNeighbouringCellsAreFine) {
  SeparationWatch watch = watchOf(2);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_FALSE(watch.update(0, {0.0, 0.0, 0.0}, frame * kFrame));
    EXPECT_FALSE(watch.update(1, {0.3, 0.0, 0.0}, frame * kFrame));
  }
}

TEST(SeparationWatchTest, ASmallGapIsTooCloseAfterThreePoses) {
  SeparationWatch watch = watchOf(2);
  watch.update(0, {0.0, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(watch.update(1, {0.234, 0.0, 0.0}, 0.0));
  EXPECT_FALSE(watch.update(1, {0.234, 0.0, 0.0}, kFrame));
  EXPECT_TRUE(watch.update(1, {0.234, 0.0, 0.0}, 2 * kFrame));
  ASSERT_TRUE(watch.violation().has_value());
  EXPECT_NEAR(0.004, watch.violation()->gap_m, 1e-12);
}

TEST(SeparationWatchTest, OneBadPoseStopsNobody) {
  SeparationWatch watch = watchOf(2);
  for (int frame = 0; frame < 60; ++frame) {
    const double x_m = frame % 10 == 9 ? 0.21 : 0.3;
    EXPECT_FALSE(watch.update(0, {0.0, 0.0, 0.0}, frame * kFrame));
    EXPECT_FALSE(watch.update(1, {x_m, 0.0, 0.0}, frame * kFrame)) << frame;
  }
}

TEST(SeparationWatchTest, IgnoresWhatIsNoPoseAndWhatIsLate) {
  SeparationWatch watch = watchOf(2);
  watch.update(0, {0.0, 0.0, 0.0}, 1.0);
  watch.update(1, {0.3, 0.0, 0.0}, 1.0);
  EXPECT_FALSE(watch.update(1, {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 1.1));
  EXPECT_FALSE(watch.update(1, {0.1, 0.0, 0.0}, 0.9));
  EXPECT_NEAR(0.07, watch.closest().gap_m, 1e-12);
  // Another run of a simulation begins.
  watch.update(1, {0.4, 0.0, 0.0}, -10.0);
  EXPECT_NEAR(0.17, watch.closest().gap_m, 1e-12);
}

/// Robot 1 rests; robot 0 drives towards it at the speed limit and brakes so that it stands at x.
/// @return whether the watch ever objects before it stands
bool objectsTo(double stop_x_m, bool brakes) {
  const double speed_mps = 0.25;
  const double braking_m = speed_mps * speed_mps / (2.0 * 0.6);
  SeparationWatch watch = watchOf(2);
  double x_m = stop_x_m - 0.6;
  for (int frame = 0; frame < 400; ++frame) {
    watch.update(1, {0.3, 0.0, 0.0}, frame * kFrame);
    if (watch.update(0, {x_m, 0.0, 0.0}, frame * kFrame)) {
      return true;
    }
    const double left_m = stop_x_m - x_m;
    const double now_mps =
        brakes && left_m < braking_m ? std::sqrt(std::max(0.0, 2.0 * 0.6 * left_m)) : speed_mps;
    x_m = brakes ? std::min(stop_x_m, x_m + now_mps * kFrame) : x_m + now_mps * kFrame;
    if (x_m > 0.3) {
      break;
    }
  }
  return false;
}

TEST(SeparationWatchTest, BrakingForTheNextCellIsNoReasonToStop) {
  EXPECT_FALSE(objectsTo(0.0, true));
  EXPECT_FALSE(objectsTo(0.012, true)) << "even with the largest tracking error";
}

TEST(SeparationWatchTest, ARobotThatStoppedWhileItWasNotSeenIsNoReasonToStop) {
  for (const double unseen_s : {0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0, 3.0}) {
    SCOPED_TRACE(unseen_s);
    SeparationWatch watch = watchOf(2);
    const double speed_mps = 0.25;
    const double stopping_m = std::min(0.045, speed_mps * unseen_s);
    double stamp_s = 0.0;
    for (double x_m = -0.3; x_m < -stopping_m; x_m += speed_mps * kFrame, stamp_s += kFrame) {
      EXPECT_FALSE(watch.update(1, {0.3, 0.0, 0.0}, stamp_s));
      EXPECT_FALSE(watch.update(0, {x_m, 0.0, 0.0}, stamp_s));
    }
    stamp_s += unseen_s;
    for (int frame = 0; frame < 20; ++frame, stamp_s += kFrame) {
      EXPECT_FALSE(watch.update(1, {0.3, 0.0, 0.0}, stamp_s));
      EXPECT_FALSE(watch.update(0, {0.0, 0.0, 0.0}, stamp_s));
    }
  }
}

TEST(SeparationWatchTest, StopsWhoDoesNotBrakeBeforeContact) {
  EXPECT_TRUE(objectsTo(0.0, false));
  SeparationWatch watch = watchOf(2);
  watch.update(1, {0.3, 0.0, 0.0}, 0.0);
  double x_m = -0.3;
  double stamp_s = 0.0;
  while (!watch.update(0, {x_m, 0.0, 0.0}, stamp_s)) {
    ASSERT_LT(x_m, 0.07) << "contact";
    stamp_s += kFrame;
    x_m += 0.25 * kFrame;
  }
  // What is left has to be enough for latency, response and braking, and hardly more.
  const double gap_m = watch.closest().gap_m;
  const double needed_m = 0.25 * (0.05 + 0.1) + 0.25 * 0.25 / 2.0;
  EXPECT_GT(gap_m, needed_m);
  EXPECT_LT(gap_m, needed_m + 2 * 0.25 * kFrame) << "a robot that can still brake is left alone";
}

}  // namespace
}  // namespace sylph
