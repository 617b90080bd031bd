#include "sylph_core/control/pose_predictor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace sylph {
namespace {

TEST(PosePredictorTest, ARobotWithoutCommandsStays) {
  const PosePredictor predictor({0.05, 0.1});
  const MotionState state = predictor.predict({1.0, 2.0, 0.5}, 3.0, 3.2);
  EXPECT_DOUBLE_EQ(1.0, state.pose.x_m);
  EXPECT_DOUBLE_EQ(2.0, state.pose.y_m);
  EXPECT_DOUBLE_EQ(0.5, state.pose.yaw_rad);
  EXPECT_DOUBLE_EQ(0.0, speed(state.twist_map));
}

TEST(PosePredictorTest, ACommandCountsFromItsLatencyOn) {
  PosePredictor predictor({0.1, 0.0});
  predictor.command(1.0, {0.2, 0.0, 0.0});
  EXPECT_NEAR(0.0, predictor.predict({}, 1.0, 1.1).pose.x_m, 1e-12);
  EXPECT_NEAR(0.2 * 0.15, predictor.predict({}, 1.0, 1.25).pose.x_m, 1e-12);
}

TEST(PosePredictorTest, OnlyTheMotionSinceTheCaptureIsAdded) {
  PosePredictor predictor({0.0, 0.0});
  predictor.command(1.0, {0.2, 0.0, 0.0});
  EXPECT_NEAR(0.2 * 0.05, predictor.predict({}, 1.30, 1.35).pose.x_m, 1e-12);
}

TEST(PosePredictorTest, SpeedFollowsWithTheLag) {
  PosePredictor predictor({0.0, 0.1});
  predictor.command(0.0, {0.0, 0.25, 0.0});
  const MotionState state = predictor.predict({}, 0.0, 0.1);
  EXPECT_NEAR(0.25 * (1.0 - std::exp(-1.0)), state.twist_map.y_mps, 1e-12);
  EXPECT_NEAR(0.25 * (0.1 - 0.1 * (1.0 - std::exp(-1.0))), state.pose.y_m, 1e-12);
}

TEST(PosePredictorTest, AgreesWithSmallStepsThroughManyCommands) {
  const BaseModel model{0.04, 0.12};
  PosePredictor predictor(model);
  double x_m = 0.0;
  double v_mps = 0.0;
  double captured_x_m = 0.0;
  const double step_s = 1e-4;
  // Commands every 0.02 s, captured at 2.0 s, asked for 2.15 s.
  const auto commandAt = [](double time_s) {
    return 0.2 * std::sin(3.0 * std::floor(time_s / 0.02 + 1e-9) * 0.02);
  };
  for (int i = 0; i < 21500; ++i) {
    const double time_s = i * step_s;
    if (i % 200 == 0) {
      predictor.command(time_s, {commandAt(time_s), 0.0, 0.0});
    }
    const double u = time_s < model.latency_s ? 0.0 : commandAt(time_s - model.latency_s);
    if (i == 20000) {
      captured_x_m = x_m;
    }
    x_m += v_mps * step_s;
    v_mps += (u - v_mps) / model.lag_s * step_s;
  }
  const MotionState state = predictor.predict({captured_x_m, 0.0, 0.0}, 2.0, 2.15);
  EXPECT_NEAR(x_m, state.pose.x_m, 1e-4);
  EXPECT_NEAR(v_mps, state.twist_map.x_mps, 1e-3);
}

TEST(PosePredictorTest, RemembersHowARobotWasStoppedHoweverLongThatIsAgo) {
  PosePredictor predictor({0.0, 0.1});
  predictor.command(1.0, {0.2, 0.0, 0.0});
  predictor.forgetBefore(2.0);
  for (int tick = 0; tick < 5000; ++tick) {
    predictor.command(2.5 + 0.02 * tick, {});
  }
  EXPECT_NEAR(0.2 * 0.5 + 0.2 * 0.1, predictor.predict({}, 2.0, 100.0).pose.x_m, 1e-6);
}

TEST(PosePredictorTest, ABaseStopsByItselfWhenNoCommandCameForItsTimeout) {
  PosePredictor predictor({0.05, 0.1, 0.2});
  predictor.command(1.0, {0.2, 0.0, 0.0});
  predictor.command(1.1, {0.2, 0.0, 0.0});  // until 1.35
  const double rest_x_m = 0.2 * 0.3;        // the lags of start and stop are alike
  EXPECT_NEAR(rest_x_m, predictor.predict({}, 1.0, 9.0).pose.x_m, 1e-9);
  EXPECT_NEAR(0.0, speed(predictor.predict({}, 5.0, 9.0).twist_map), 1e-9);
  // It is known later too, when commands go on.
  predictor.command(8.0, {0.2, 0.0, 0.0});
  EXPECT_NEAR(rest_x_m, predictor.predict({}, 1.0, 8.05).pose.x_m, 1e-9);
  EXPECT_NEAR(0.2 * (1.0 - std::exp(-1.0)), predictor.predict({}, 8.1, 8.15).twist_map.x_mps, 1e-9);
}

TEST(PosePredictorTest, YawIsPredictedAcrossTheSeam) {
  PosePredictor predictor({0.0, 0.0});
  predictor.command(0.0, {0.0, 0.0, 0.5});
  EXPECT_NEAR(-M_PI + 0.05, predictor.predict({0.0, 0.0, M_PI - 0.05}, 0.0, 0.2).pose.yaw_rad,
              1e-12);
}

TEST(PosePredictorTest, RefusesNegativeDelays) {
  EXPECT_THROW(PosePredictor({-0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(PosePredictor({0.1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(PosePredictor({0.1, 0.1, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
