#include "sylph_core/geometry/pose2d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sylph {
namespace {

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
