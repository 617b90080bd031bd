#include "sylph_core/control/pid.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace sylph {
namespace {

constexpr double kStep_s = 0.02;

PidGains gains(double proportional, double integral, double derivative) {
  PidGains result;
  result.proportional = proportional;
  result.integral = integral;
  result.derivative = derivative;
  return result;
}

TEST(PidTest, ProportionalShareIsGainTimesError) {
  Pid pid(gains(2.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(0.6, pid.update(0.3, 0.0, kStep_s));
}

TEST(PidTest, IntegralSumsErrorOverTime) {
  Pid pid(gains(0.0, 0.5, 0.0));
  for (int step = 0; step < 50; ++step) {
    pid.update(0.2, 0.0, kStep_s);
  }
  EXPECT_NEAR(0.5 * 0.2 * 1.0, pid.integralShare(), 1e-12);
}

TEST(PidTest, IntegralIsClamped) {
  PidGains limited = gains(0.0, 1.0, 0.0);
  limited.integral_limit = 0.05;
  Pid pid(limited);
  for (int step = 0; step < 1000; ++step) {
    pid.update(-1.0, 0.0, kStep_s);
  }
  EXPECT_DOUBLE_EQ(-0.05, pid.integralShare());
}

TEST(PidTest, IntegralRestsWhileTheOutputIsLimitedAndUnwindsFreely) {
  PidGains limited = gains(1.0, 1.0, 0.0);
  limited.output_limit = 0.1;
  Pid pid(limited);
  for (int step = 0; step < 1000; ++step) {
    EXPECT_DOUBLE_EQ(0.1, pid.update(1.0, 0.0, kStep_s));
  }
  EXPECT_NEAR(0.0, pid.integralShare(), 1e-12);
  // The error changes its sign: the output follows at once.
  EXPECT_LT(pid.update(-0.05, 0.0, kStep_s), 0.0);
}

TEST(PidTest, IntegralRestsWhileTheActuatorIsLimitedElsewhere) {
  Pid pid(gains(1.0, 1.0, 0.0));
  for (int step = 0; step < 100; ++step) {
    pid.update(0.2, 0.0, kStep_s, true);
  }
  EXPECT_DOUBLE_EQ(0.0, pid.integralShare());
}

TEST(PidTest, ANewSetPointGivesNoDerivativeKick) {
  Pid pid(gains(0.0, 0.0, 1.0));
  pid.update(0.0, 0.5, kStep_s);
  EXPECT_DOUBLE_EQ(0.0, pid.update(10.0, 0.5, kStep_s));
}

TEST(PidTest, DerivativeTendsToTheRateOfTheMeasurement) {
  Pid pid(gains(0.0, 0.0, 0.5));
  double output = 0.0;
  for (int step = 0; step < 200; ++step) {
    output = pid.update(0.0, 0.3 * step * kStep_s, kStep_s);
  }
  EXPECT_NEAR(-0.5 * 0.3, output, 1e-9);
}

TEST(PidTest, ARepeatedFrameMovesNeitherIntegralNorDerivative) {
  Pid pid(gains(1.0, 1.0, 1.0));
  pid.update(0.1, 0.0, kStep_s);
  const double integral = pid.integralShare();
  EXPECT_DOUBLE_EQ(0.1 + integral, pid.update(0.1, 5.0, 0.0));
  EXPECT_DOUBLE_EQ(integral, pid.integralShare());
}

TEST(PidTest, ResetForgets) {
  Pid pid(gains(1.0, 1.0, 1.0));
  pid.update(0.5, 0.0, kStep_s);
  pid.update(0.5, 1.0, kStep_s);
  pid.reset();
  EXPECT_DOUBLE_EQ(0.0, pid.update(0.0, 7.0, kStep_s));
}

TEST(PidTest, RefusesNegativeGainsAndLimits) {
  EXPECT_THROW(Pid(gains(-1.0, 0.0, 0.0)), std::invalid_argument);
  EXPECT_THROW(Pid(gains(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0)),
               std::invalid_argument);
  PidGains bad = gains(1.0, 0.0, 0.0);
  bad.output_limit = 0.0;
  EXPECT_THROW(Pid{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace sylph
