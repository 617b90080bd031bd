#include "sylph_core/control/twist_limiter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace sylph {
namespace {

TEST(TwistLimiterTest, LimitsTheSpeedAsAVector) {
  TwistLimiter limiter({0.25, 1e6, 0.5, 1e6});
  const Twist2d limited = limiter.limit({0.3, 0.4, 0.0}, 0.02);
  EXPECT_NEAR(0.15, limited.x_mps, 1e-12);
  EXPECT_NEAR(0.20, limited.y_mps, 1e-12);
}

TEST(TwistLimiterTest, LimitsTheTurnRateWithItsSign) {
  TwistLimiter limiter({0.25, 1e6, 0.5, 1e6});
  EXPECT_DOUBLE_EQ(-0.5, limiter.limit({0.0, 0.0, -2.0}, 0.02).turn_radps);
}

TEST(TwistLimiterTest, LimitsTheChangeWithTheTimeThatHasPassed) {
  TwistLimiter limiter({1.0, 0.6, 1.0, 2.0});
  EXPECT_NEAR(0.6 * 0.02, limiter.limit({1.0, 0.0, 1.0}, 0.02).x_mps, 1e-12);
  EXPECT_NEAR(0.6 * 0.07, limiter.limit({1.0, 0.0, 1.0}, 0.05).x_mps, 1e-12);
  EXPECT_NEAR(2.0 * 0.07, limiter.last().turn_radps, 1e-12);
}

TEST(TwistLimiterTest, LimitsTheChangeAsAVector) {
  TwistLimiter limiter({1.0, 1.0, 1.0, 1.0});
  limiter.limit({0.0, 0.3, 0.0}, 1.0);
  const Twist2d limited = limiter.limit({0.4, 0.0, 0.0}, 0.25);
  EXPECT_NEAR(0.25, std::hypot(limited.x_mps, limited.y_mps - 0.3), 1e-12);
  EXPECT_NEAR(0.2, limited.x_mps, 1e-12);
}

TEST(TwistLimiterTest, RampsToExactlyZero) {
  TwistLimiter limiter({0.25, 1e6, 0.5, 2.0});
  limiter.limit({0.2, -0.1, 0.1}, 1.0);
  int steps = 0;
  while ((speed(limiter.last()) > 0.0 || limiter.last().turn_radps != 0.0) && steps < 1000) {
    const double before = speed(limiter.last());
    EXPECT_LE(before - speed(limiter.ramp(1.0, 0.02)), 0.02 + 1e-12);
    ++steps;
  }
  EXPECT_EQ(12, steps);  // 0.2236 m/s at 1 m/s^2
}

TEST(TwistLimiterTest, RefusesLimitsThatAreNotPositive) {
  EXPECT_THROW(TwistLimiter({0.0, 1.0, 1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(TwistLimiter({1.0, 1.0, -1.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
