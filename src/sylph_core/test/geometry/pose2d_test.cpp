#include "sylph_core/geometry/pose2d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

double drawBetween(double low, double high, Rng& rng) {
  return low + (high - low) * drawFraction(rng);
}

Pose2d randomPose(Rng& rng) {
  return {drawBetween(-10.0, 10.0, rng), drawBetween(-10.0, 10.0, rng),
          drawBetween(-2.0 * M_PI, 2.0 * M_PI, rng)};
}

void expectEqual(const Pose2d& expected, const Pose2d& pose) {
  EXPECT_NEAR(expected.x_m, pose.x_m, 1e-12);
  EXPECT_NEAR(expected.y_m, pose.y_m, 1e-12);
  EXPECT_NEAR(0.0, shortestAngle(expected.yaw_rad, pose.yaw_rad), 1e-12);
}

TEST(Pose2dTest, AFrameTurnedLeftTakesItsXToTheOthersY) {
  const Pose2d map_from_robot = {3.0, 1.0, M_PI / 2.0};
  const Point ahead = transform(map_from_robot, {2.0, 0.0});
  EXPECT_NEAR(3.0, ahead.x, 1e-12);
  EXPECT_NEAR(3.0, ahead.y, 1e-12);
}

TEST(Pose2dProperty, PosesAreAGroup) {
  Rng rng(1);
  for (int round = 0; round < 1000; ++round) {
    const Pose2d a = randomPose(rng);
    const Pose2d b = randomPose(rng);
    const Pose2d c = randomPose(rng);
    expectEqual(a, compose(a, {}));
    expectEqual(a, compose({}, a));
    expectEqual({}, compose(a, inverse(a)));
    expectEqual({}, compose(inverse(a), a));
    expectEqual(compose(compose(a, b), c), compose(a, compose(b, c)));
    EXPECT_LE(std::abs(compose(a, b).yaw_rad), M_PI);
  }
}

TEST(Pose2dProperty, TransformingByTheProductIsTransformingTwice) {
  Rng rng(2);
  for (int round = 0; round < 1000; ++round) {
    const Pose2d a = randomPose(rng);
    const Pose2d b = randomPose(rng);
    const Point point = position(randomPose(rng));
    const Point other = position(randomPose(rng));
    const Point once = transform(compose(a, b), point);
    const Point twice = transform(a, transform(b, point));
    EXPECT_NEAR(twice.x, once.x, 1e-12);
    EXPECT_NEAR(twice.y, once.y, 1e-12);
    EXPECT_NEAR(distance(point, other), distance(transform(a, point), transform(a, other)), 1e-12);
  }
}

TEST(Pose2dTest, AnglesAreNormalisedToTheHalfOpenCircle) {
  EXPECT_DOUBLE_EQ(M_PI, normalizeAngle(M_PI));
  EXPECT_DOUBLE_EQ(M_PI, normalizeAngle(-M_PI));
  EXPECT_NEAR(-0.5, normalizeAngle(4.0 * M_PI - 0.5), 1e-12);
}

TEST(Pose2dTest, TheShortestAngleCrossesTheSeam) {
  EXPECT_NEAR(0.2, shortestAngle(M_PI - 0.1, -M_PI + 0.1), 1e-12);
  EXPECT_NEAR(-0.2, shortestAngle(-M_PI + 0.1, M_PI - 0.1), 1e-12);
}

TEST(Pose2dTest, ARobotFacingNorthDrivesNorthByDrivingForward) {
  const Twist2d twist_robot = robotFromMap({0.0, 0.2, 0.1}, M_PI / 2.0);
  EXPECT_NEAR(0.2, twist_robot.x_mps, 1e-12);
  EXPECT_NEAR(0.0, twist_robot.y_mps, 1e-12);
  EXPECT_DOUBLE_EQ(0.1, twist_robot.turn_radps);
}

TEST(Pose2dTest, MapAndRobotFrameThereAndBackIsTheIdentity) {
  const Twist2d twist_map = {0.1, -0.2, 0.3};
  for (double yaw_rad = -3.0; yaw_rad < 3.1; yaw_rad += 0.7) {
    const Twist2d back = mapFromRobot(robotFromMap(twist_map, yaw_rad), yaw_rad);
    EXPECT_NEAR(twist_map.x_mps, back.x_mps, 1e-12);
    EXPECT_NEAR(twist_map.y_mps, back.y_mps, 1e-12);
  }
}

TEST(Pose2dTest, APoseWithOneNotANumberIsNotFinite) {
  EXPECT_TRUE(isFinite({1.0, 2.0, 3.0}));
  EXPECT_FALSE(isFinite({1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_FALSE(isFinite({std::numeric_limits<double>::infinity(), 2.0, 3.0}));
}

}  // namespace
}  // namespace sylph
