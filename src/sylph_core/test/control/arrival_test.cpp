#include "sylph_core/control/arrival.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

constexpr double kCell_m = 0.3;
const ArrivalOptions kOptions;

DrivePath pathOf(const std::vector<Point>& points) {
  DrivePath path(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    path.append(points[i], 0.024);
  }
  return path;
}

bool arrives(const DrivePath& path, const Pose2d& pose, const Vector2& velocity = {}) {
  return hasArrived(path, 0, pose, velocity, 0.0, kOptions);
}

TEST(ArrivalTest, WithinToleranceOfTheEndAndAtRest) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}});
  EXPECT_TRUE(arrives(path, {kCell_m - 0.009, 0.0, 0.0}));
  EXPECT_TRUE(arrives(path, {kCell_m + 0.006, 0.006, 0.0}));
  EXPECT_FALSE(arrives(path, {kCell_m - 0.011, 0.0, 0.0}));
  EXPECT_FALSE(arrives(path, {kCell_m, 0.011, 0.0}));
}

TEST(ArrivalTest, TheHeadingCounts) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}});
  EXPECT_TRUE(arrives(path, {kCell_m, 0.0, 0.05}));
  EXPECT_FALSE(arrives(path, {kCell_m, 0.0, -0.06}));
}

TEST(ArrivalTest, ARobotThatWillOvershootHasNotArrived) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}});
  EXPECT_TRUE(arrives(path, {kCell_m - 0.005, 0.0, 0.0}, {0.1, 0.0}));    // rests 3 mm behind it
  EXPECT_FALSE(arrives(path, {kCell_m - 0.005, 0.0, 0.0}, {0.25, 0.0}));  // 47 mm
}

TEST(ArrivalTest, ARobotThatDrivesThroughHasArrivedAtFullSpeed) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}, {2 * kCell_m, 0}});
  EXPECT_FALSE(arrives(path, {kCell_m - 0.015, 0.0, 0.0}, {0.25, 0.0}));
  EXPECT_TRUE(arrives(path, {kCell_m - 0.005, 0.0, 0.0}, {0.25, 0.0}));
  EXPECT_TRUE(arrives(path, {kCell_m + 0.05, 0.0, 0.0}, {0.25, 0.0}));
  EXPECT_FALSE(arrives(path, {kCell_m + 0.05, 0.02, 0.0}, {0.25, 0.0}));  // beside its path
}

TEST(ArrivalTest, ARobotThatTurnsOffHasArrivedOnTheNextLeg) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}, {kCell_m, kCell_m}});
  EXPECT_TRUE(arrives(path, {kCell_m - 0.006, 0.006, 0.0}, {0.09, 0.09}));
  EXPECT_TRUE(arrives(path, {kCell_m - 0.009, 0.02, 0.0}, {0.05, 0.12}));
  EXPECT_FALSE(arrives(path, {kCell_m - 0.02, 0.004, 0.0}, {0.13, 0.02}));
  EXPECT_FALSE(arrives(path, {kCell_m, 0.0, 0.0}, {0.2, 0.0}));  // goes straight on instead
}

TEST(ArrivalTest, ARobotThatTurnsBackHasArrivedOnlyAtTheCentre) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}, {0, 0}});
  EXPECT_FALSE(arrives(path, {0.5 * kCell_m, 0.0, 0.0}));
  EXPECT_FALSE(arrives(path, {kCell_m - 0.02, 0.0, 0.0}, {-0.1, 0.0}));
  EXPECT_TRUE(arrives(path, {kCell_m - 0.008, 0.0, 0.0}));
}

TEST(ArrivalTest, DistanceToRestOfAFinishedPathIsThatToItsEnd) {
  const DrivePath path = pathOf({{0, 0}, {kCell_m, 0}});
  EXPECT_DOUBLE_EQ(0.1, distanceToRest(path, 1, {kCell_m, 0.1}));
  EXPECT_NEAR(0.1, distanceToRest(path, 0, {0.1, 0.1}), 1e-12);
}

}  // namespace
}  // namespace sylph
