// Schedules with which robots once came to harm, although nothing that protects them was off.
#include <gtest/gtest.h>

#include <string>

#include "open_lab.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

namespace sylph_rehearsal {
namespace {

using sylph_sim::FaultKind;

/// robot_0 drives north past robot_1, which is parked in the column beside.
sylph::Experiment passing(std::uint32_t seed) {
  return openLab(7, 4, {{{6, 1}, {0, 1}}, {{1, 2}, {1, 2}}}, seed);
}

TEST(FalsePlaceTest, AfterAShortOcclusionMovesNoRobot) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    for (const double unseen_s : {0.12, 0.3, 1.0}) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(unseen_s) + " s");
      const Rehearsal run = rehearse(passing(seed), {}, nullptr,
                                     {simulated(FaultKind::Lost, {0}, 4.0, unseen_s),
                                      simulated(FaultKind::Jump, {0}, 4.0, kForGood, -0.1)});
      EXPECT_EQ(Ending::Stopped, run.ending) << run.cause;
      EXPECT_NE(std::string::npos, run.cause.find("robot_0: no good pose: pose jumped"))
          << run.cause;
    }
  }
}

TEST(FalsePlaceTest, IsNotBelievedBecauseTheOperatorResumesForAnotherReason) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    for (const double jump_m : {-0.1, 0.1}) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(jump_m) + " m");
      const Rehearsal run = rehearse(passing(seed), {}, nullptr,
                                     {simulated(FaultKind::Jump, {0}, 4.0, kForGood, jump_m),
                                      faultOf(LabFaultKind::Stop, {}, 6.0, 1.0)});
      EXPECT_EQ(Ending::Stopped, run.ending) << run.cause;
      EXPECT_NE(std::string::npos, run.cause.find("confirm its pose")) << run.cause;
    }
  }
}

TEST(FalsePlaceTest, IsNotBelievedOfARobotThatWaitsForItsFirstTask) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const sylph::Experiment queue = openLab(7, 1, {{{3, 0}, {0, 0}}, {{4, 0}, {1, 0}}}, seed);
    const Rehearsal run =
        rehearse(queue, {}, nullptr, {simulated(FaultKind::Jump, {1}, 1.5, 4.0, 0.065)});
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
  }
}

TEST(FalsePlaceTest, IsNotBelievedOfARobotThatHasNotDrivenYet) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Rehearsal run = rehearse(passing(seed), {}, nullptr,
                                   {simulated(sylph_sim::FaultKind::Jump, {0}, 0.3, 3.0, 0.031)});
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
  }
}

TEST(CarriedRobotTest, GoesOnFromWhereTheOperatorHasConfirmedIt) {
  const Rehearsal run = rehearse(
      passing(1), {}, nullptr,
      {simulated(FaultKind::Lost, {0}, 4.0, 1.0), simulated(FaultKind::Stuck, {0}, 3.8, 1.0),
       faultOf(LabFaultKind::Stop, {}, 7.0, 1.0)});
  EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
}

TEST(LaunchAnewTest, StoppedRobotsStayWhereTheyAre) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Rehearsal run = rehearse(passing(seed), {}, nullptr,
                                   {faultOf(LabFaultKind::Stop, {}, 4.0, kForGood),
                                    faultOf(LabFaultKind::LaunchAnew, {}, 6.0, kForGood)});
    EXPECT_EQ(Ending::Stopped, run.ending) << run.cause;
    EXPECT_EQ("the central node has no plan", run.cause);
  }
}

}  // namespace
}  // namespace sylph_rehearsal
