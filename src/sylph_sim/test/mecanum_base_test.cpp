#include "sylph_sim/mecanum_base.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sylph_sim {
namespace {

constexpr double kStep = 0.005;

/// A base that does exactly what it is told, at once.
BaseOptions idealBase() {
  BaseOptions options;
  options.wheel_speed_limit_radps = 1e3;
  options.wheel_acceleration_limit_radps2 = 1e9;
  options.wheel_lag_s = 0.0;
  options.command_latency_s = 0.0;
  options.command_timeout_s = 1e3;
  options.command_resolution = 0.0;
  options.wheel_scale_error = 0.0;
  options.speed_noise = 0.0;
  options.slip = 0.0;
  options.slip_noise = 0.0;
  options.lateral_slip = 0.0;
  return options;
}

/// The default base with all its noise, which keeps a command.
BaseOptions noisyBase() {
  BaseOptions options;
  options.command_timeout_s = 1e3;
  return options;
}

/// Drives with one command, given at time 0, until `until_s`.
MecanumBase driven(const BaseOptions& options, const sylph::Twist2d& twist_robot, double until_s,
                   const BaseFault& fault = {}, const sylph::Pose2d& start = {}) {
  MecanumBase base(options, start, sylph::Rng(7));
  base.command(twist_robot, 0.0);
  const int steps = static_cast<int>(std::lround(until_s / kStep));
  for (int step = 0; step < steps; ++step) {
    base.step(step * kStep, kStep, fault);
  }
  return base;
}

TEST(IntegrateTest, AQuarterTurnEndsWhereTheCircleDoes) {
  // Radius 0.5 m, a quarter of the circle in 1 s, starting along map y.
  const double rate = M_PI / 2.0;
  const sylph::Pose2d end = integrate({1.0, 2.0, M_PI / 2.0}, {0.5 * rate, 0.0, rate}, 1.0);
  EXPECT_NEAR(0.5, end.x_m, 1e-12);
  EXPECT_NEAR(2.5, end.y_m, 1e-12);
  EXPECT_NEAR(M_PI, std::abs(end.yaw_rad), 1e-12);
}

TEST(IntegrateTest, ManySmallPartsEqualOneWhole) {
  const sylph::Twist2d twist{0.2, -0.1, 0.8};
  sylph::Pose2d pose{0.3, 0.4, 0.5};
  const sylph::Pose2d whole = integrate(pose, twist, 1.0);
  for (int part = 0; part < 100; ++part) {
    pose = integrate(pose, twist, 0.01);
  }
  EXPECT_NEAR(whole.x_m, pose.x_m, 1e-12);
  EXPECT_NEAR(whole.y_m, pose.y_m, 1e-12);
  EXPECT_NEAR(whole.yaw_rad, pose.yaw_rad, 1e-12);
}

TEST(IntegrateTest, HardlyTurningIsContinuousWithNotTurning) {
  const sylph::Pose2d straight = integrate({}, {1.0, 0.5, 0.0}, 1.0);
  const sylph::Pose2d turning = integrate({}, {1.0, 0.5, 1e-7}, 1.0);
  EXPECT_NEAR(straight.x_m, turning.x_m, 1e-6);
  EXPECT_NEAR(straight.y_m, turning.y_m, 1e-6);
}

TEST(MecanumBaseTest, AnIdealBaseFollowsTheCommandInEachDirection) {
  const sylph::Pose2d forward = driven(idealBase(), {0.25, 0.0, 0.0}, 2.0).pose();
  EXPECT_NEAR(0.5, forward.x_m, 1e-9);
  EXPECT_NEAR(0.0, forward.y_m, 1e-9);
  const sylph::Pose2d left = driven(idealBase(), {0.0, 0.25, 0.0}, 2.0).pose();
  EXPECT_NEAR(0.5, left.y_m, 1e-9);
  const sylph::Pose2d turned = driven(idealBase(), {0.0, 0.0, 0.5}, 2.0).pose();
  EXPECT_NEAR(1.0, turned.yaw_rad, 1e-9);
}

TEST(MecanumBaseTest, ForwardMeansAlongTheRobotAndNotTheMap) {
  const sylph::Pose2d start{1.0, 1.0, M_PI / 2.0};
  const sylph::Pose2d end = driven(idealBase(), {0.25, 0.0, 0.0}, 2.0, {}, start).pose();
  EXPECT_NEAR(1.0, end.x_m, 1e-9);
  EXPECT_NEAR(1.5, end.y_m, 1e-9);
}

TEST(MecanumBaseTest, StandsStillWithoutACommand) {
  MecanumBase base(BaseOptions{}, {}, sylph::Rng(1));
  for (int step = 0; step < 400; ++step) {
    base.step(step * kStep, kStep);
  }
  EXPECT_EQ(0.0, base.pose().x_m);
  EXPECT_EQ(0.0, base.pose().yaw_rad);
}

TEST(MecanumBaseTest, TheLagReachesItsShareAfterOneTimeConstant) {
  BaseOptions options = idealBase();
  options.wheel_lag_s = 0.1;
  EXPECT_NEAR(0.25 * (1.0 - std::exp(-1.0)), driven(options, {0.25, 0.0, 0.0}, 0.1).twist().x_mps,
              1e-9);
}

TEST(MecanumBaseTest, ACommandTakesEffectAfterItsLatency) {
  BaseOptions options = idealBase();
  options.command_latency_s = 0.02;
  EXPECT_EQ(0.0, driven(options, {0.25, 0.0, 0.0}, 0.02).twist().x_mps);
  EXPECT_NEAR(0.25, driven(options, {0.25, 0.0, 0.0}, 0.025).twist().x_mps, 1e-9);
}

TEST(MecanumBaseTest, LatchesACommandUntilItsTimeout) {
  BaseOptions options = idealBase();
  options.command_timeout_s = 0.5;
  EXPECT_NEAR(0.25, driven(options, {0.25, 0.0, 0.0}, 0.5).twist().x_mps, 1e-9);
  EXPECT_EQ(0.0, driven(options, {0.25, 0.0, 0.0}, 0.52).twist().x_mps);
}

TEST(MecanumBaseTest, AccelerationOfAWheelIsLimited) {
  BaseOptions options = idealBase();
  options.wheel_acceleration_limit_radps2 = 10.0;
  const double limit_mps2 = 10.0 * options.geometry.wheel_radius_m;
  EXPECT_NEAR(limit_mps2 * 0.1, driven(options, {5.0, 0.0, 0.0}, 0.1).twist().x_mps, 1e-9);
}

TEST(MecanumBaseTest, SpeedOfAWheelIsLimited) {
  BaseOptions options = idealBase();
  options.wheel_speed_limit_radps = 10.0;
  EXPECT_NEAR(10.0 * options.geometry.wheel_radius_m,
              driven(options, {5.0, 0.0, 0.0}, 1.0).twist().x_mps, 1e-9);
}

TEST(MecanumBaseTest, CommandsAreRoundedToTheResolution) {
  BaseOptions options = idealBase();
  options.command_resolution = 0.001;
  EXPECT_NEAR(0.123, driven(options, {0.1234, 0.0, 0.0}, 0.1).twist().x_mps, 1e-9);
}

TEST(MecanumBaseTest, ACommandThatIsNotFiniteIsIgnored) {
  MecanumBase base(idealBase(), {}, sylph::Rng(1));
  base.command({0.1, 0.0, 0.0}, 0.0);
  base.command({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 0.0);
  base.step(0.0, kStep);
  EXPECT_NEAR(0.1, base.twist().x_mps, 1e-9);
}

TEST(MecanumBaseTest, SlipCostsItsShare) {
  BaseOptions options = idealBase();
  options.slip = 0.1;
  options.lateral_slip = 0.2;
  const sylph::Twist2d twist = driven(options, {0.2, 0.1, 0.0}, 0.1).twist();
  EXPECT_NEAR(0.2 * 0.9, twist.x_mps, 1e-9);
  EXPECT_NEAR(0.1 * 0.9 * 0.8, twist.y_mps, 1e-9);
}

TEST(MecanumBaseTest, NoiseKeepsNearTheCommandButOff) {
  const sylph::Pose2d end = driven(noisyBase(), {0.25, 0.0, 0.0}, 0.5).pose();
  EXPECT_NEAR(0.1, end.x_m, 0.02);
  EXPECT_NE(0.0, end.y_m);
  EXPECT_NE(0.0, end.yaw_rad);
}

TEST(MecanumBaseTest, TheSameSeedGivesTheSameRun) {
  const sylph::Pose2d first = driven(noisyBase(), {0.2, 0.1, 0.1}, 1.0).pose();
  const sylph::Pose2d second = driven(noisyBase(), {0.2, 0.1, 0.1}, 1.0).pose();
  EXPECT_EQ(first.x_m, second.x_m);
  EXPECT_EQ(first.y_m, second.y_m);
  EXPECT_EQ(first.yaw_rad, second.yaw_rad);
}

TEST(MecanumBaseTest, FaultsDoWhatTheySay) {
  const sylph::Twist2d command{0.2, 0.0, 0.0};
  EXPECT_EQ(0.0, driven(idealBase(), command, 1.0, {0.0, false, 0.0}).pose().x_m);
  EXPECT_NEAR(0.04, driven(idealBase(), command, 1.0, {0.2, false, 0.0}).pose().x_m, 1e-9);
  EXPECT_EQ(0.0, driven(idealBase(), command, 1.0, {1.0, true, 0.0}).pose().x_m);
  EXPECT_NEAR(0.05, driven(idealBase(), {}, 1.0, {1.0, false, 0.05}).pose().y_m, 1e-9);
}

TEST(MecanumBaseTest, RefusesOptionsOutOfTheirBounds) {
  const auto refuses = [](double BaseOptions::*member, double value) {
    BaseOptions options;
    options.*member = value;
    EXPECT_THROW(MecanumBase(options, {}, sylph::Rng(1)), std::invalid_argument) << value;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses(&BaseOptions::wheel_speed_limit_radps, 0.0);
  refuses(&BaseOptions::wheel_acceleration_limit_radps2, nan);
  refuses(&BaseOptions::wheel_lag_s, -0.1);
  refuses(&BaseOptions::command_latency_s, -0.1);
  refuses(&BaseOptions::command_timeout_s, 0.0);
  refuses(&BaseOptions::command_resolution, nan);
  refuses(&BaseOptions::wheel_scale_error, 0.3);
  refuses(&BaseOptions::speed_noise, 0.6);
  refuses(&BaseOptions::slip, -0.1);
  refuses(&BaseOptions::slip_noise, nan);
  refuses(&BaseOptions::lateral_slip, 0.6);
  refuses(&BaseOptions::noise_correlation_s, 0.0);
}

}  // namespace
}  // namespace sylph_sim
