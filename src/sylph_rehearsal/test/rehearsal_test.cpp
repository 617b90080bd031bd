#include "sylph_rehearsal/rehearsal.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "open_lab.hpp"
#include "sylph_rehearsal/seeds.hpp"

namespace sylph_rehearsal {
namespace {

/// Of a lab map, planned without a policy: this is about carrying plans out.
sylph::Experiment labExperiment(const std::string& name, std::uint32_t seed) {
  sylph::Experiment experiment =
      experimentOf(std::string(MAPS_DIR) + "/" + name + ".yaml", seed, 0);
  experiment.planning.planner = "lacam";
  return experiment;
}

class LabMapTest : public testing::TestWithParam<const char*> {};

TEST_P(LabMapTest, IsCarriedOutFromStartToGoal) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Rehearsal run = rehearse(labExperiment(GetParam(), seed), {}, nullptr);
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
    EXPECT_EQ(8, run.result.arrived);
    EXPECT_GT(*run.result.min_separation_m, 0.02);
    EXPECT_LT(run.result.max_tracking_error_m, 0.012);
    EXPECT_GE(run.result.execution_s, run.result.ideal_execution_s);
    EXPECT_LT(run.result.execution_s, 1.5 * run.result.ideal_execution_s);
  }
}

INSTANTIATE_TEST_SUITE_P(Lab, LabMapTest, testing::Values("lab_random", "lab_room", "lab_maze"));

TEST(RehearsalTest, TheSameSeedGivesTheSameEventLog) {
  const Rehearsal once = rehearse(labExperiment("lab_room", 3), {}, nullptr);
  const Rehearsal again = rehearse(labExperiment("lab_room", 3), {}, nullptr);
  EXPECT_GT(once.event_log.size(), 100U);
  EXPECT_EQ(once.event_log, again.event_log);
  EXPECT_EQ(once.result.min_separation_m, again.result.min_separation_m);
  const Rehearsal other = rehearse(labExperiment("lab_room", 4), {}, nullptr);
  EXPECT_NE(once.event_log, other.event_log);
}

TEST(FaultedRehearsalTest, GoesOnAfterWhatPasses) {
  using sylph_sim::FaultKind;
  LabFault cut = faultOf(LabFaultKind::Network, {}, 4.0, 5.0);
  cut.link.loss = 1.0;
  LabFault bad_network = faultOf(LabFaultKind::Network, {}, 1.0, 1e6);
  bad_network.link = {0.1, 0.3, 0.3, 0.2, 0.2, 0.2};
  for (const LabFault& fault : {cut,
                                bad_network,
                                faultOf(LabFaultKind::CrashCentral, {}, 5.0, 2.0),
                                faultOf(LabFaultKind::CrashCentral, {}, 0.7, 2.0),
                                faultOf(LabFaultKind::CrashRobot, {2}, 5.0, 2.0),
                                faultOf(LabFaultKind::CrashPlanner, {}, 0.2, 1.0),
                                faultOf(LabFaultKind::CrashPlanner, {}, 5.0, 1.0),
                                faultOf(LabFaultKind::CrashBridge, {}, 5.0, 1.0),
                                faultOf(LabFaultKind::ClockSkew, {1}, 3.0, 10.0, 0.03),
                                faultOf(LabFaultKind::Pause, {}, 5.0, 2.0),
                                faultOf(LabFaultKind::Stop, {}, 5.0, 2.0),
                                simulated(FaultKind::Stuck, {0}, 4.0, 3.0),
                                simulated(FaultKind::Deaf, {0}, 4.0, 3.0),
                                simulated(FaultKind::Lost, {}, 4.0, 2.0),
                                simulated(FaultKind::Nan, {1}, 4.0, 1.0),
                                simulated(FaultKind::Frozen, {1}, 4.0, 1.0),
                                simulated(FaultKind::YawFlip, {1}, 4.0, 1.0),
                                simulated(FaultKind::Jump, {1}, 4.0, 1.0),
                                simulated(FaultKind::Swap, {1, 3}, 4.0, 1.0),
                                simulated(FaultKind::Silent, {}, 4.0, 3.0)}) {
    SCOPED_TRACE(toName(fault));
    const Rehearsal run = rehearse(labExperiment("lab_room", 3), {}, nullptr, {fault});
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
  }
}

TEST(FaultedRehearsalTest, GoesOnAfterAllRobotsWereUnseenForAMoment) {
  const std::vector<LabFault> occlusions = {simulated(sylph_sim::FaultKind::Lost, {}, 3.0, 0.3),
                                            simulated(sylph_sim::FaultKind::Lost, {}, 6.0, 0.5),
                                            simulated(sylph_sim::FaultKind::Lost, {}, 9.0, 0.2),
                                            simulated(sylph_sim::FaultKind::Lost, {}, 12.0, 1.0)};
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Rehearsal run = rehearse(labExperiment("lab_room", seed), {}, nullptr, occlusions);
    EXPECT_EQ(Ending::Finished, run.ending) << run.cause;
  }
}

TEST(FaultedRehearsalTest, StopsWithACauseAfterWhatDoesNot) {
  using sylph_sim::FaultKind;
  for (const auto& [fault, cause] :
       {std::pair{simulated(FaultKind::Dead, {0}, 4.0, kForGood), "robot_0: no progress"},
        std::pair{simulated(FaultKind::Lost, {0}, 4.0, kForGood), "robot_0: no good pose"},
        std::pair{simulated(FaultKind::YawFlip, {0}, 4.0, kForGood), "robot_0: no good pose"},
        std::pair{faultOf(LabFaultKind::CrashRobot, {0}, 4.0, kForGood), "robot_0: no report"},
        std::pair{faultOf(LabFaultKind::CrashCentral, {}, 4.0, kForGood),
                  "the central node is silent"},
        std::pair{faultOf(LabFaultKind::Stop, {}, 4.0, kForGood), "stop: by the operator"},
        std::pair{faultOf(LabFaultKind::DeclareLost, {0}, 4.0, kForGood), "robot_0 is lost"}}) {
    SCOPED_TRACE(toName(fault));
    const Rehearsal run = rehearse(labExperiment("lab_room", 3), {}, nullptr, {fault});
    EXPECT_EQ(Ending::Stopped, run.ending);
    EXPECT_NE(std::string::npos, run.cause.find(cause)) << run.cause;
  }
}

TEST(FaultedRehearsalTest, PlansTheRestAnewAroundALostRobot) {
  const Rehearsal run = rehearse(labExperiment("lab_room", 3), {}, nullptr,
                                 {faultOf(LabFaultKind::DeclareLost, {0}, 4.0, kForGood)});
  EXPECT_EQ(1U, run.result.replans);
  EXPECT_EQ(7, run.result.arrived);
}

TEST(FaultedRehearsalTest, ARobotThatIsDeclaredLostOnItsGoalIsTheCause) {
  for (double at_s = 2.0; at_s < 5.0; at_s += 0.2) {
    SCOPED_TRACE(at_s);
    const Rehearsal run = rehearse(openLab(3, 3, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 2}}}), {}, nullptr,
                                   {faultOf(LabFaultKind::DeclareLost, {0}, at_s, kForGood)});
    EXPECT_NE(Ending::Violated, run.ending) << run.cause;
  }
}

TEST(FaultedRehearsalTest, TheSameFaultsGiveTheSameEventLog) {
  sylph::Rng rng(5);
  const sylph::Experiment experiment = labExperiment("lab_room", 3);
  const std::vector<LabFault> faults = randomFaults(experiment, rng);
  const Rehearsal once = rehearse(experiment, {}, nullptr, faults);
  EXPECT_EQ(once.event_log, rehearse(experiment, {}, nullptr, faults).event_log);
  EXPECT_NE(once.event_log, rehearse(experiment, {}, nullptr).event_log);
}

TEST(RehearsalTest, NamesWhyThereIsNoPlan) {
  sylph::Experiment experiment = labExperiment("lab_room", 1);
  experiment.grid.setObstacle(experiment.robots[1].goal);
  const Rehearsal run = rehearse(experiment, {}, nullptr);
  EXPECT_EQ(Ending::Stopped, run.ending);
  EXPECT_NE(std::string::npos, run.cause.find("of robot_1 lies on an obstacle")) << run.cause;
}

TEST(RehearsalTest, PlansLongWaysOfManyRobots) {
  std::vector<std::pair<sylph::Cell, sylph::Cell>> missions;
  missions.reserve(24);
  for (int robot = 0; robot < 24; ++robot) {
    missions.push_back({{robot, 0}, {robot, 239}});
  }
  RehearsalOptions options;
  options.time_limit_s = 3.0;
  const Rehearsal run = rehearse(openLab(24, 240, missions), options, nullptr);
  EXPECT_EQ(239, run.result.plan_steps) << run.cause;
}

TEST(RehearsalTest, NamesTheOptionThatIsOutOfItsBounds) {
  RehearsalOptions options;
  options.network.loss = 1.5;
  try {
    rehearse(labExperiment("lab_room", 1), options, nullptr);
    FAIL() << "the option was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(0U, std::string(error.what()).find("network.loss")) << error.what();
  }
}

TEST(SeedsTest, AreOneOrARange) {
  EXPECT_EQ(5U, seedsFromText("5").first);
  EXPECT_EQ(1U, seedsFromText("5").count());
  EXPECT_EQ(10U, seedsFromText("1-10").count());
  for (const char* text : {"", "-3", "4-3", "1-", "a", "1-2x", "1 - 2", "4294967296"}) {
    EXPECT_THROW(seedsFromText(text), std::invalid_argument) << text;
  }
}

TEST(ExperimentOfTest, HasAsManyRobotsAsWanted) {
  const std::string path = std::string(MAPS_DIR) + "/lab_room.yaml";
  EXPECT_EQ(8U, experimentOf(path, 1, 0).robots.size());
  EXPECT_EQ(3U, experimentOf(path, 1, 3).robots.size());
  const sylph::Experiment many = experimentOf(path, 1, 20);
  ASSERT_EQ(20U, many.robots.size());
  EXPECT_EQ("robot_19", many.robots[19].name);
  EXPECT_NO_THROW(sylph::requireValid(toInstance(many)));
  EXPECT_THROW(experimentOf(path, 1, 1000), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_rehearsal
