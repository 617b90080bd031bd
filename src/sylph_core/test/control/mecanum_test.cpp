#include "sylph_core/control/mecanum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace sylph {
namespace {

const MecanumGeometry kGeometry = {0.05, 0.1, 0.15};

TEST(MecanumTest, AllWheelsRollForwardWhenDrivingForward) {
  const WheelSpeeds wheels = MecanumKinematics(kGeometry).toWheels({0.25, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(5.0, wheels.front_left_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.front_right_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.rear_left_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.rear_right_radps);
}

TEST(MecanumTest, DrivingLeftTurnsTheDiagonalsAgainstEachOther) {
  const WheelSpeeds wheels = MecanumKinematics(kGeometry).toWheels({0.0, 0.25, 0.0});
  EXPECT_DOUBLE_EQ(-5.0, wheels.front_left_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.front_right_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.rear_left_radps);
  EXPECT_DOUBLE_EQ(-5.0, wheels.rear_right_radps);
}

TEST(MecanumTest, TurningLeftRollsTheRightSideForward) {
  const WheelSpeeds wheels = MecanumKinematics(kGeometry).toWheels({0.0, 0.0, 1.0});
  EXPECT_DOUBLE_EQ(-5.0, wheels.front_left_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.front_right_radps);
  EXPECT_DOUBLE_EQ(-5.0, wheels.rear_left_radps);
  EXPECT_DOUBLE_EQ(5.0, wheels.rear_right_radps);
}

TEST(MecanumTest, InverseThenForwardKinematicsIsTheIdentity) {
  const MecanumKinematics kinematics(kGeometry);
  for (const Twist2d& twist : {Twist2d{0.1, 0.2, -0.3}, Twist2d{-0.25, 0.05, 0.5}, Twist2d{}}) {
    const Twist2d back = kinematics.toTwist(kinematics.toWheels(twist));
    EXPECT_NEAR(twist.x_mps, back.x_mps, 1e-12);
    EXPECT_NEAR(twist.y_mps, back.y_mps, 1e-12);
    EXPECT_NEAR(twist.turn_radps, back.turn_radps, 1e-12);
  }
}

TEST(MecanumTest, WheelsThatFightEachOtherDoNotMoveTheBase) {
  const Twist2d twist = MecanumKinematics(kGeometry).toTwist({1.0, 1.0, -1.0, -1.0});
  EXPECT_DOUBLE_EQ(0.0, speed(twist));
  EXPECT_DOUBLE_EQ(0.0, twist.turn_radps);
}

TEST(MecanumTest, LimitingTheWheelsKeepsTheDirection) {
  const MecanumKinematics kinematics(kGeometry);
  const Twist2d limited = kinematics.limitWheels({0.3, 0.4, 0.0}, 7.0);  // fastest wheel: 14 rad/s
  EXPECT_NEAR(0.15, limited.x_mps, 1e-12);
  EXPECT_NEAR(0.20, limited.y_mps, 1e-12);
  EXPECT_DOUBLE_EQ(0.1, kinematics.limitWheels({0.1, 0.0, 0.0}, 7.0).x_mps);
}

TEST(MecanumTest, RefusesGeometryAndLimitsThatAreNotPositive) {
  EXPECT_THROW(MecanumKinematics({0.0, 0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(MecanumKinematics({0.05, -0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(MecanumKinematics({0.05, 0.1, std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
  EXPECT_THROW(MecanumKinematics(kGeometry).limitWheels({}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
