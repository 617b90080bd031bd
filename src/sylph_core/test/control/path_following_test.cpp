#include <gtest/gtest.h>

#include <string>

#include "closed_loop.hpp"

namespace sylph {
namespace {

constexpr double kCell_m = 0.3;
constexpr double kCell_s = 1.2;  // at the speed limit
constexpr double kBudget_m = 0.012;

/// Cell centres along moves such as "EEN", from the origin.
std::vector<Point> walk(const std::string& moves) {
  std::vector<Point> points;
  Point here;
  for (const char move : moves) {
    here.x += move == 'E' ? kCell_m : move == 'W' ? -kCell_m : 0.0;
    here.y += move == 'N' ? kCell_m : move == 'S' ? -kCell_m : 0.0;
    points.push_back(here);
  }
  return points;
}

FollowerOptions followerFor(double lag_s) {
  FollowerOptions options;
  options.lag_s = lag_s;
  return options;
}

PlantOptions plantFor(double delay_s, double lag_s) {
  PlantOptions plant;
  plant.command_delay_s = delay_s - plant.camera_delay_s;
  plant.lag_s = lag_s;
  return plant;
}

/// A drive with a model that knows the delays.
DriveRecord drive(const std::string& moves, double delay_s, double lag_s) {
  const PlantOptions plant = plantFor(delay_s, lag_s);
  ClosedLoop loop(followerFor(lag_s), {plant.command_delay_s, lag_s}, plant, {});
  const std::vector<Point> points = walk(moves);
  return loop.drive(points, std::vector<double>(points.size(), 0.0), 60.0);
}

class Delays : public testing::TestWithParam<double> {};

TEST_P(Delays, OneCellEndsWithoutOvershoot) {
  const DriveRecord record = drive("E", GetParam(), 0.15);
  ASSERT_TRUE(record.finished);
  EXPECT_LT(record.largest_overshoot_m, 0.002);
  EXPECT_LT(record.largest_error_m, 0.003);
  // Delay, speeding up and braking come on top.
  EXPECT_LT(record.time_s, kCell_s + 0.43 + GetParam());
}

TEST_P(Delays, AStraightRunIsDrivenThrough) {
  const DriveRecord record = drive("NNNNN", GetParam(), 0.15);
  ASSERT_TRUE(record.finished);
  EXPECT_LT(record.largest_error_m, 0.004);
  EXPECT_LT(record.time_s, 5 * kCell_s / 0.95 + 0.43 + GetParam());  // it slips by 5 % sideways
  EXPECT_LT(record.largest_speed_mps, 0.251);
}

TEST_P(Delays, CornersAreRoundedWithinTheBudgetAndCostLittle) {
  const DriveRecord record = drive("ENESSEEN", GetParam(), 0.15);
  ASSERT_TRUE(record.finished);
  EXPECT_LT(record.largest_error_m, 0.8 * kBudget_m);
  EXPECT_LT(record.time_s, 8 * kCell_s / 0.96 + 6 * 0.32 + 0.43 + GetParam());
}

TEST_P(Delays, ARobotTurnsBackAtACentre) {
  const DriveRecord record = drive("EWN", GetParam(), 0.15);
  ASSERT_TRUE(record.finished);
  EXPECT_LT(record.largest_error_m, kBudget_m);
}

TEST_P(Delays, TheHeadingIsHeld) {
  const PlantOptions plant = plantFor(GetParam(), 0.15);
  ClosedLoop loop(followerFor(0.15), {plant.command_delay_s, 0.15}, plant, {0.0, 0.0, 0.03});
  const DriveRecord record = loop.drive(walk("EEE"), {0.0, 0.0, 0.0}, 60.0);
  ASSERT_TRUE(record.finished);
  EXPECT_NEAR(0.0, loop.pose().yaw_rad, 0.005);
  EXPECT_LT(record.largest_heading_error_rad, 0.031);
}

INSTANTIATE_TEST_SUITE_P(Seconds, Delays, testing::Values(0.03, 0.1, 0.15));

TEST(PathFollowingTest, AWrongModelCostsAccuracyButNotTheBudget) {
  for (const double error_s : {-0.025, 0.025}) {
    SCOPED_TRACE(error_s);
    const PlantOptions plant = plantFor(0.06 + error_s, 0.1);
    ClosedLoop loop(followerFor(0.1), {0.05, 0.1}, plant, {});
    const DriveRecord record = loop.drive(walk("ENENEE"), std::vector<double>(6, 0.0), 60.0);
    ASSERT_TRUE(record.finished);
    EXPECT_LT(record.largest_error_m, kBudget_m);
  }
}

TEST(PathFollowingTest, AReleaseThatComesDuringBrakingIsUsed) {
  const PlantOptions plant = plantFor(0.04, 0.1);
  for (double release_s = 0.9; release_s < 1.8; release_s += 0.05) {
    SCOPED_TRACE(release_s);
    ClosedLoop loop(followerFor(0.1), {0.03, 0.1}, plant, {});
    const DriveRecord record = loop.drive(walk("EN"), {0.0, release_s}, 60.0);
    ASSERT_TRUE(record.finished);
    EXPECT_LT(record.largest_error_m, kBudget_m);
    EXPECT_LT(record.time_s, std::max(1.6, release_s) + kCell_s + 0.6);
  }
}

TEST(PathFollowingTest, ARobotPlacedBesideItsCentreReturnsToItsPathFirst) {
  const PlantOptions plant = plantFor(0.04, 0.1);
  ClosedLoop loop(followerFor(0.1), {0.03, 0.1}, plant, {0.02, 0.06, 0.0});
  loop.follower().reset({0.0, 0.0});
  const DriveRecord record = loop.drive(walk("EE"), {0.0, 0.0}, 60.0);
  ASSERT_TRUE(record.finished);
  EXPECT_LT(record.largest_error_m, 0.061);
  EXPECT_LT(record.time_s, 2 * kCell_s + 3.0);
}

TEST(PathFollowingTest, ATaskIsDoneOnlyInItsEndCell) {
  const PlantOptions plant = plantFor(0.06, 0.1);
  ClosedLoop loop(followerFor(0.1), {0.05, 0.1}, plant, {});
  const DriveRecord record = loop.drive(walk("EEEE"), std::vector<double>(4, 0.0), 60.0);
  ASSERT_EQ(4U, record.done_s.size());
  for (std::size_t leg = 1; leg < 4; ++leg) {
    EXPECT_NEAR(kCell_s / 0.98, record.done_s[leg] - record.done_s[leg - 1], 0.2);
  }
}

}  // namespace
}  // namespace sylph
