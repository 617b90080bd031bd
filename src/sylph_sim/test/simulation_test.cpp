#include "sylph_sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sylph_sim {
namespace {

constexpr double kStart = 1000.0;

/// Two robots side by side in a corridor: robot_0 at (0,0), robot_1 at (0,1).
sylph::Experiment corridor(std::uint32_t seed = 1) {
  sylph::Experiment experiment;
  experiment.grid = sylph::Grid::fromText("....#\n");
  experiment.cell_size_m = 0.3;
  experiment.seed = seed;
  experiment.robots.resize(2);
  experiment.robots[0].name = "robot_0";
  experiment.robots[0].start = {0, 0};
  experiment.robots[1].name = "robot_1";
  experiment.robots[1].start = {0, 1};
  return experiment;
}

/// Sends the same command to one robot at 50 Hz.
void drive(Simulation& simulation, std::size_t robot, const sylph::Twist2d& twist, double for_s) {
  const int steps = static_cast<int>(std::lround(for_s / simulation.stepDuration()));
  for (int step = 0; step < steps; ++step) {
    if (step % 4 == 0) {
      simulation.command(robot, twist);
    }
    simulation.step();
  }
}

TEST(SimulationTest, RobotsStartWhereTheMapLies) {
  SimulationOptions options;
  options.start_offset_m = 0.0;
  sylph::Experiment elsewhere = corridor();
  elsewhere.corner = {-10.0, 5.0};
  const Simulation simulation(options, elsewhere, kStart);
  EXPECT_NEAR(-9.85, simulation.poses()[0].x_m, 1e-9);
  EXPECT_NEAR(5.15, simulation.poses()[0].y_m, 1e-9);
}

TEST(SimulationTest, RobotsStartNearTheirCellsCentresButNotPerfectly) {
  const SimulationOptions options;
  const Simulation simulation(options, corridor(), kStart);
  ASSERT_EQ(2U, simulation.poses().size());
  EXPECT_NEAR(0.15, simulation.poses()[0].x_m, options.start_offset_m);
  EXPECT_NEAR(0.15, simulation.poses()[0].y_m, options.start_offset_m);
  EXPECT_NEAR(0.45, simulation.poses()[1].x_m, options.start_offset_m);
  EXPECT_NEAR(0.0, simulation.poses()[1].yaw_rad, options.start_yaw_offset_rad);
  EXPECT_NE(0.15, simulation.poses()[0].x_m);
  EXPECT_EQ(kStart, simulation.time());
  EXPECT_EQ(0U, simulation.collisions());
}

TEST(SimulationTest, TimeIsTheCountOfSteps) {
  Simulation simulation(SimulationOptions{}, corridor(), kStart);
  for (int step = 0; step < 2000; ++step) {
    simulation.step();
  }
  EXPECT_NEAR(kStart + 10.0, simulation.time(), 1e-9);
}

TEST(SimulationTest, OnlyTheCommandedRobotMoves) {
  Simulation simulation(SimulationOptions{}, corridor(), kStart);
  const std::vector<sylph::Pose2d> before = simulation.poses();
  drive(simulation, 1, {0.2, 0.0, 0.0}, 1.0);
  EXPECT_EQ(before[0].x_m, simulation.poses()[0].x_m);
  EXPECT_GT(simulation.poses()[1].x_m, before[1].x_m + 0.1);
}

TEST(SimulationTest, CountsAStagedCollision) {
  Simulation simulation(SimulationOptions{}, corridor(), kStart);
  EXPECT_NEAR(0.07, simulation.minSeparation(), 0.02);
  drive(simulation, 0, {0.2, 0.0, 0.0}, 1.0);
  EXPECT_EQ(1U, simulation.collisions());
  EXPECT_EQ(0.0, simulation.minSeparation());
}

TEST(SimulationTest, CountsARobotThatLeavesTheFreeCells) {
  Simulation simulation(SimulationOptions{}, corridor(), kStart);
  drive(simulation, 1, {0.3, 0.0, 0.0}, 4.0);
  EXPECT_EQ(1U, simulation.obstacleEntries());
}

TEST(SimulationTest, FramesTellWhereRobotsWereAtTheirCapture) {
  SimulationOptions options;
  options.cameras.occlusion_probability = 0.0;
  options.cameras.frame_loss_probability = 0.0;
  Simulation simulation(options, corridor(), kStart);
  std::vector<CapturedFrame> frames;
  for (int step = 0; step < 200; ++step) {
    for (const CapturedFrame& frame : simulation.step()) {
      frames.push_back(frame);
    }
  }
  EXPECT_NEAR(119, static_cast<double>(frames.size()), 1);
  EXPECT_NEAR(simulation.poses()[1].x_m, frames.back().bodies[1].pose.x_m, 0.005);
  EXPECT_NEAR(kStart + 1.0 - 0.008, frames.back().captured_s, 0.009);
}

TEST(SimulationTest, TheSameSeedAndCommandsGiveTheSameRun) {
  const auto run = [](std::uint32_t seed) {
    Simulation simulation(SimulationOptions{}, corridor(seed), kStart);
    drive(simulation, 1, {0.2, 0.05, 0.1}, 1.0);
    return simulation.poses()[1].x_m;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(SimulationTest, ScriptedFaultsCountFromTheFirstMotionAndInjectedOnesFromNow) {
  Simulation simulation(SimulationOptions{}, corridor(), kStart);
  simulation.schedule({FaultKind::Stuck, {0}, 0.5, 1.0, 0.0});
  drive(simulation, 0, {}, 2.0);  // zero commands do not begin it
  EXPECT_EQ(0U, simulation.activeFaults());
  drive(simulation, 1, {0.1, 0.0, 0.0}, 0.4);
  EXPECT_EQ(0U, simulation.activeFaults());
  drive(simulation, 1, {0.1, 0.0, 0.0}, 0.2);
  EXPECT_EQ(1U, simulation.activeFaults());
  const double stuck_x_m = simulation.poses()[0].x_m;
  drive(simulation, 0, {0.1, 0.0, 0.0}, 0.4);
  EXPECT_EQ(stuck_x_m, simulation.poses()[0].x_m);
  simulation.inject({FaultKind::Lost, {}, 0.0, 1.0, 0.0});
  EXPECT_EQ(2U, simulation.activeFaults());
}

TEST(SimulationTest, ADeafRobotKeepsItsLastCommandUntilTheTimeout) {
  SimulationOptions options;
  options.base.command_timeout_s = 0.5;
  Simulation simulation(options, corridor(), kStart);
  drive(simulation, 1, {0.2, 0.0, 0.0}, 0.5);
  simulation.inject({FaultKind::Deaf, {1}, 0.0, 10.0, 0.0});
  const double x_m = simulation.poses()[1].x_m;
  drive(simulation, 1, {}, 0.4);
  EXPECT_GT(simulation.poses()[1].x_m, x_m + 0.06);
  drive(simulation, 1, {0.2, 0.0, 0.0}, 1.0);
  const double stopped_x_m = simulation.poses()[1].x_m;
  drive(simulation, 1, {0.2, 0.0, 0.0}, 1.0);
  EXPECT_NEAR(stopped_x_m, simulation.poses()[1].x_m, 1e-3);
}

TEST(SimulationTest, RefusesABadFaultAtOnceAndAnExperimentWithoutRobots) {
  Simulation simulation(SimulationOptions{}, corridor(), kStart);
  EXPECT_THROW(simulation.schedule({FaultKind::Lost, {7}, 0.0, 1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(simulation.command(7, {}), std::out_of_range);
  sylph::Experiment empty = corridor();
  empty.robots.clear();
  EXPECT_THROW(Simulation(SimulationOptions{}, empty, kStart), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_sim
