#include "sylph_sim/step_pacer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph_sim {
namespace {

constexpr double kStep = 0.005;

TEST(StepPacerTest, StepsKeepPaceWithTheWall) {
  for (const double speed : {0.5, 1.0, 4.0, 8.0}) {
    StepPacer pacer(kStep, speed, 0.1);
    int steps = 0;
    for (int tick = 0; tick <= 3000; ++tick) {
      steps += pacer.stepsDue(100.0 + tick * 0.001);
    }
    EXPECT_NEAR(3.0 * speed / kStep, steps, 1.0) << speed;
    EXPECT_NEAR(speed, pacer.speed(), 0.02 * speed) << speed;
  }
}

TEST(StepPacerTest, AShortHitchIsCaughtUp) {
  StepPacer pacer(kStep, 1.0, 0.1);
  EXPECT_EQ(0, pacer.stepsDue(0.0));
  EXPECT_EQ(10, pacer.stepsDue(0.05));
  EXPECT_EQ(10, pacer.stepsDue(0.10));
}

TEST(StepPacerTest, ALongHitchSlowsTheClockInsteadOfSkippingSteps) {
  StepPacer pacer(kStep, 1.0, 0.1);
  EXPECT_EQ(0, pacer.stepsDue(0.0));
  EXPECT_EQ(20, pacer.stepsDue(10.0));  // the backlog at most
  EXPECT_EQ(0, pacer.stepsDue(10.001));
  EXPECT_EQ(1, pacer.stepsDue(10.006));  // and on from there, not the rest of the hitch
  EXPECT_LT(pacer.speed(), 0.05);
}

TEST(StepPacerTest, TheBacklogIsSimulatedTimeAtAnySpeed) {
  for (const double speed : {0.5, 1.0, 4.0, 8.0}) {
    StepPacer pacer(kStep, speed, 0.02);
    EXPECT_EQ(0, pacer.stepsDue(0.0));
    EXPECT_EQ(4, pacer.stepsDue(10.0)) << speed;
  }
}

TEST(StepPacerTest, RefusesWhatIsNotPositive) {
  EXPECT_THROW(StepPacer(0.0, 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(StepPacer(kStep, -1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(StepPacer(kStep, 1.0, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_sim
