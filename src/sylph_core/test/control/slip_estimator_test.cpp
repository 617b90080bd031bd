#include "sylph_core/control/slip_estimator.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph {
namespace {

/// Drives `way_m` in steps of 2 mm with a base that loses 4 % forwards and 8 % sideways.
void drive(SlipEstimator& slip, double way_m, double sign = 1.0) {
  for (double driven_m = 0.0; driven_m < way_m; driven_m += 0.002) {
    slip.learn({sign * 0.002, 0.0}, {sign * 0.96 * 0.002, 0.0}, 0.008);
    slip.learn({0.0, sign * 0.002}, {0.0, sign * 0.92 * 0.002}, 0.008);
  }
}

TEST(SlipEstimatorTest, StartsWithoutSlip) {
  const SlipEstimator slip({});
  const Twist2d command = slip.compensate({0.2, -0.1, 0.3});
  EXPECT_DOUBLE_EQ(0.2, command.x_mps);
  EXPECT_DOUBLE_EQ(-0.1, command.y_mps);
  EXPECT_DOUBLE_EQ(0.3, command.turn_radps);
}

TEST(SlipEstimatorTest, LearnsEachAxisInBothDirections) {
  for (const double sign : {1.0, -1.0}) {
    SlipEstimator slip({});
    drive(slip, 2.0, sign);
    EXPECT_NEAR(0.96, slip.forwardGain(), 0.001);
    EXPECT_NEAR(0.92, slip.sidewaysGain(), 0.001);
    EXPECT_NEAR(0.2, 0.96 * slip.compensate({0.2, 0.0, 0.0}).x_mps, 1e-3);
  }
}

TEST(SlipEstimatorTest, AStuckRobotIsNotDrivenHarderThanTheLimit) {
  SlipEstimator slip({});
  for (int i = 0; i < 10000; ++i) {
    slip.learn({0.002, 0.002}, {0.0, -0.001}, 0.008);
  }
  EXPECT_DOUBLE_EQ(0.9, slip.forwardGain());
  EXPECT_DOUBLE_EQ(0.9, slip.sidewaysGain());
}

TEST(SlipEstimatorTest, ABaseThatIsTooFastIsLeftToTheControlLoop) {
  SlipEstimator slip({});
  slip.learn({0.3, 0.0}, {0.45, 0.0}, 1.2);
  EXPECT_DOUBLE_EQ(1.0, slip.forwardGain());
}

TEST(SlipEstimatorTest, SlowMotionTellsNothing) {
  SlipEstimator slip({});
  slip.learn({0.0005, 0.0}, {0.0, 0.0}, 0.008);
  EXPECT_DOUBLE_EQ(1.0, slip.forwardGain());
}

TEST(SlipEstimatorTest, RefusesOptionsOutOfBounds) {
  EXPECT_THROW(SlipEstimator({0.6, 0.3, 0.1}), std::invalid_argument);
  EXPECT_THROW(SlipEstimator({0.1, 0.0, 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
