#include "sylph_core/control/separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/grid/rng.hpp"

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

/// All pairs, each with a watch of its own: what a watch over all has to say as well.
class Pairwise {
 public:
  Pairwise(const std::vector<Footprint>& sizes, const SeparationLimits& limits) {
    for (std::size_t a = 0; a < sizes.size(); ++a) {
      for (std::size_t b = a + 1; b < sizes.size(); ++b) {
        pairs_.emplace(std::pair(a, b), SeparationWatch({sizes[a], sizes[b]}, limits));
      }
    }
  }

  /// The gap of the closest pair that is too close.
  std::optional<double> update(std::size_t robot, const Pose2d& pose, double stamp_s) {
    std::optional<double> least_m;
    for (auto& [pair, watch] : pairs_) {
      const bool takes_part = pair.first == robot || pair.second == robot;
      if (takes_part && watch.update(pair.first == robot ? 0 : 1, pose, stamp_s)) {
        least_m = std::min(watch.violation()->gap_m, least_m.value_or(watch.violation()->gap_m));
      }
    }
    return least_m;
  }

  double closest() const {
    return least([](const SeparationWatch& watch) { return watch.closest().gap_m; });
  }
  double closestEver() const {
    return least([](const SeparationWatch& watch) { return watch.closestEver().gap_m; });
  }

 private:
  template <typename Of>
  double least(Of of) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [pair, watch] : pairs_) {
      least = std::min(least, of(watch));
    }
    return least;
  }

  std::map<std::pair<std::size_t, std::size_t>, SeparationWatch> pairs_;
};

TEST(SeparationWatchProperty, AgreesWithOneWatchForEachPair) {
  constexpr std::size_t kRobots = 12;
  SeparationLimits limits;
  limits.confirmations = 1;  // more count a robot's poses, whichever pair each is about
  int violations = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    std::vector<Footprint> sizes(kRobots);
    std::vector<Pose2d> poses(kRobots);
    std::vector<Vector2> velocities_mps(kRobots);
    const double room_m = drawBetween(rng, 2.0, 20.0);
    for (std::size_t robot = 0; robot < kRobots; ++robot) {
      sizes[robot].length_m = drawBetween(rng, 0.0, 0.6);
      sizes[robot].width_m = drawBetween(rng, 0.0, 0.6);
      poses[robot] = {drawBetween(rng, 0.0, room_m), drawBetween(rng, 0.0, room_m),
                      drawBetween(rng, -3.0, 3.0)};
      velocities_mps[robot] = {drawNormal(rng), drawNormal(rng)};
    }
    SeparationWatch watch(sizes, limits);
    Pairwise pairwise(sizes, limits);
    for (int frame = 0; frame < 120; ++frame) {
      for (std::size_t robot = 0; robot < kRobots; ++robot) {
        Pose2d& pose = poses[robot];
        pose.x_m += velocities_mps[robot].x * kFrame;
        pose.y_m += velocities_mps[robot].y * kFrame;
        // Not every robot is seen from the start, or always; some jump far away and back.
        const double offset_m = drawIndex(rng, 50) == 0 ? 1e3 : 0.0;
        if (drawIndex(rng, 4) == 0) {
          continue;
        }
        const Pose2d seen = {pose.x_m + offset_m, pose.y_m, pose.yaw_rad};
        const std::optional<double> expected_m = pairwise.update(robot, seen, frame * kFrame);
        ASSERT_EQ(expected_m.has_value(),
                  watch.update(static_cast<int>(robot), seen, frame * kFrame));
        if (expected_m) {
          ASSERT_EQ(*expected_m, watch.violation()->gap_m);
          ++violations;
        }
        ASSERT_EQ(pairwise.closestEver(), watch.closestEver().gap_m);
      }
      ASSERT_EQ(pairwise.closest(), watch.closest().gap_m);
    }
  }
  EXPECT_GT(violations, 1000) << "little has been compared";
}

}  // namespace
}  // namespace sylph
