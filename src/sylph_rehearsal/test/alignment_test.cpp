#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "open_lab.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

// Robots that were put down by hand, turned and off the middle of their cells, are aligned before
// their plan starts.

namespace sylph_rehearsal {
namespace {

/// Six robots with a free cell between them, which change sides.
sylph::Experiment roomyLab(std::uint32_t seed) {
  sylph::Experiment experiment = openLab(5, 5,
                                         {{{0, 0}, {4, 4}},
                                          {{0, 2}, {4, 2}},
                                          {{0, 4}, {4, 0}},
                                          {{4, 0}, {0, 4}},
                                          {{4, 2}, {0, 2}},
                                          {{4, 4}, {0, 0}}},
                                         seed);
  experiment.planning.planner = "lacam";
  return experiment;
}

RehearsalOptions putDownByHand() {
  RehearsalOptions options;
  options.simulation.start_offset_m = 0.06;
  options.simulation.start_yaw_offset_rad = 0.5;
  options.align = true;
  return options;
}

TEST(AlignmentRehearsalTest, WhoIsPutDownByHandFinishes) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const Rehearsal run = rehearse(roomyLab(seed), putDownByHand(), nullptr);
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
    EXPECT_EQ(6, run.result.arrived);
    EXPECT_GT(*run.result.min_separation_m, 0.02);
  }
}

TEST(AlignmentRehearsalTest, IsRefusedWithoutIt) {
  RehearsalOptions options = putDownByHand();
  options.align = false;
  const Rehearsal run = rehearse(roomyLab(1), options, nullptr);
  EXPECT_EQ(Ending::Stopped, run.ending);
  EXPECT_NE(std::string::npos, run.cause.find("off the centre of its start")) << run.cause;
}

TEST(AlignmentRehearsalTest, GoesOnAfterFaultsMeanwhile) {
  using sylph_sim::FaultKind;
  LabFault cut = faultOf(LabFaultKind::Network, {}, 1.5, 3.0);
  cut.link.loss = 1.0;
  for (const LabFault& fault :
       {cut, faultOf(LabFaultKind::CrashCentral, {}, 1.5, 1.0),
        faultOf(LabFaultKind::CrashCentral, {}, 3.0, 1.0),
        faultOf(LabFaultKind::CrashRobot, {0}, 1.5, 2.0),
        faultOf(LabFaultKind::CrashBridge, {}, 2.0, 1.0), faultOf(LabFaultKind::Stop, {}, 2.0, 2.0),
        faultOf(LabFaultKind::Pause, {}, 2.0, 2.0), simulated(FaultKind::Lost, {0}, 1.5, 2.0),
        simulated(FaultKind::Deaf, {0}, 1.5, 1.0)}) {
    SCOPED_TRACE(toName(fault));
    const Rehearsal run = rehearse(roomyLab(1), putDownByHand(), nullptr, {fault});
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
  }
}

TEST(AlignmentRehearsalTest, ADeadBaseStopsTheMissionWithItsCause) {
  const Rehearsal run = rehearse(roomyLab(1), putDownByHand(), nullptr,
                                 {simulated(sylph_sim::FaultKind::Dead, {0}, 0.0, kForGood)});
  EXPECT_EQ(Ending::Stopped, run.ending);
  EXPECT_NE(std::string::npos, run.cause.find("robot_0")) << run.cause;
  EXPECT_NE(std::string::npos, run.cause.find("does not follow")) << run.cause;
}

TEST(AlignmentRehearsalTest, ExchangedBodiesTouchNobody) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Rehearsal run = rehearse(roomyLab(seed), putDownByHand(), nullptr,
                                   {simulated(sylph_sim::FaultKind::Swap, {0, 1}, 0.0, kForGood)});
    EXPECT_EQ(Ending::Stopped, run.ending) << run.cause;
  }
}

}  // namespace
}  // namespace sylph_rehearsal
