#include "sylph_core/control/robot_controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "robot_world.hpp"
#include "sylph_core/control/drive_path.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"

namespace sylph {
namespace {

TEST(RobotControllerTest, CarriesOutItsTasks) {
  RobotWorld world({2, 0});
  world.run(0.2);
  EXPECT_EQ(RobotState::Idle, world.report().state);
  world.sendEastward(3);
  EXPECT_EQ(3, world.report().accepted);
  world.run(1.0);
  EXPECT_EQ(RobotState::Moving, world.report().state);
  world.run(3.5);
  EXPECT_EQ(RobotState::Idle, world.report().state);
  EXPECT_EQ(3, world.report().done);
  EXPECT_NEAR(1.05, world.x(), 0.005);
  EXPECT_LT(world.speedNow(), 0.005);
}

TEST(RobotControllerTest, DoesNotMoveBeforeTheCentralNodeIsHeard) {
  RobotWorld world({2, 0});
  world.central_sends = false;
  world.run(0.2);
  world.sendEastward(1);
  world.run(2.0);
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_NEAR(0.15, world.x(), 1e-6);
  world.central_sends = true;
  world.run(2.0);
  EXPECT_EQ(1, world.report().done);
}

double distanceToPath(const DrivePath& path, const Point& point) {
  double smallest_m = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < path.legCount(); ++leg) {
    smallest_m = std::min(smallest_m, distanceToLeg(path.leg(leg), point));
  }
  return smallest_m;
}

/// Largest distance of the true position from the planned path while a node is starved once, from
/// `starve_after_s` after the tasks came [m].
double largestDeviation(RobotWorld& world, const std::vector<Cell>& path, double starve_after_s) {
  DrivePath planned(world.frame.toPoint(path.front()));
  for (std::size_t k = 1; k < path.size(); ++k) {
    planned.append(world.frame.toPoint(path[k]), 0.0);
  }
  world.run(0.2);
  world.sendAlong(path);
  world.run(starve_after_s);
  double largest_m = 0.0;
  for (int tick = 0; tick < 1000; ++tick) {
    if (tick < 50) {
      world.starveNodeFor(0.01);
    } else {
      world.run(0.01);
    }
    largest_m = std::max(largest_m, distanceToPath(planned, position(world.pose)));
  }
  return largest_m;
}

TEST(RobotControllerTest, ANodeThatIsStarvedAtTheWorstMomentStaysWithinTheMargin) {
  const double overrun_m = computeSafetyMargin(safetyFactors(Experiment{})).overrun_m;
  const std::vector<Cell> path = {{2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 3}};
  RobotControllerOptions options;
  options.base.timeout_s = ExecutionSpec{}.base_timeout_s;
  double worst_m = 0.0;
  for (double after_s = 0.1; after_s < 6.0; after_s += 0.03) {
    SCOPED_TRACE(after_s);
    RobotWorld world(path.front(), options);
    worst_m = std::max(worst_m, largestDeviation(world, path, after_s));
    EXPECT_EQ(4, world.report().done);  // and it goes on by itself
  }
  EXPECT_LT(worst_m, overrun_m);
  // The moments tried are the bad ones: a base that latches for half a second leaves its cells.
  RobotWorld latching(path.front());
  latching.base_timeout_s = 0.5;
  EXPECT_GT(largestDeviation(latching, path, 2.2), overrun_m);
}

TEST(RobotControllerTest, AStopRampsToZeroAtOnceAndARunGoesOn) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.mode = ExecutionMode::Stop;
  world.run(0.1);
  const double x_m = world.x();
  world.run(0.3);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  EXPECT_LT(world.x() - x_m, 0.06);
  EXPECT_EQ(RobotState::Holding, world.report().state);
  world.mode = ExecutionMode::Run;
  world.run(4.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, FinishesItsTaskWhenTheCentralNodeFallsSilent) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(0.5);
  world.central_sends = false;
  world.run(4.0);
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_NE(std::string::npos, world.report().detail.find("silent"));
  EXPECT_EQ(1, world.report().done);
  EXPECT_NEAR(0.45, world.x(), 0.012);
  world.central_sends = true;
  world.run(4.5);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, AnEmergencyStopLastsUntilStopAndResume) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.controller.onEmergencyStop(true);
  world.run(0.5);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.controller.onEmergencyStop(false);
  world.run(1.0);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.mode = ExecutionMode::Stop;
  world.run(0.5);
  world.mode = ExecutionMode::Run;
  world.run(4.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, TasksOfAPlanThatNobodyCarriesOutAreHeld) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(1.0);
  world.executed_plan_id = 0;  // the central node was launched anew
  world.run(0.5);
  const double x_m = world.x();
  world.run(5.0);
  EXPECT_NEAR(x_m, world.x(), 0.001);
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_EQ("its tasks are of plan 1, which the central node does not carry out",
            world.report().detail);
  // A plan from where it stands takes over.
  world.executed_plan_id = 2;
  world.run(0.2);
  EXPECT_EQ(TaskVerdict::Accepted,
            world.controller.onTask({2, 0, {2, 1}, {1, 1}}, world.now_s).verdict);
  world.run(4.0);
  EXPECT_EQ(1, world.report().done);
  EXPECT_EQ(2U, world.report().plan_id);
}

TEST(RobotControllerTest, ARefusedTaskIsTheReasonThatItReports) {
  RobotWorld world({2, 0});
  world.grid.setObstacle({2, 1});
  world.controller = RobotController({}, world.grid, world.frame);
  world.run(0.2);
  world.sendEastward(1);
  world.run(0.2);
  EXPECT_EQ("refuses task 0 of plan 1 from (2,0) to (2,1): not a free cell of the map",
            world.report().detail);
  world.controller.onTask({1, 0, {2, 0}, {1, 0}}, world.now_s);
  world.run(0.1);
  EXPECT_EQ("", world.report().detail);
}

TEST(RobotControllerTest, ANodeThatStartsAgainFarFromItsFirstTaskSaysSo) {
  RobotWorld world({2, 3});
  world.run(0.2);
  world.sendEastward(2);
  world.run(0.2);
  EXPECT_EQ(0, world.report().accepted);
  EXPECT_EQ("refuses task 0 of plan 1 from (2,0) to (2,1): the robot is in (2,3)",
            world.report().detail);
}

TEST(RobotControllerTest, AStateOfTheCentralNodeSentBeforeTheLastOneIsLate) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(1.0);
  world.central_sends = false;
  world.controller.onCentralState({ExecutionMode::Stop, 1, world.now_s}, world.now_s);
  world.run(0.2);
  world.controller.onCentralState({ExecutionMode::Run, 1, world.now_s - 0.3}, world.now_s);
  world.run(0.3);
  EXPECT_EQ("stopped by the central node", world.report().detail);
}

TEST(RobotControllerTest, ANodeThatStartsAgainGoesOnFromItsPastTasks) {
  RobotWorld world({2, 2});
  world.executed_plan_id = 7;
  world.run(0.2);
  for (int k = 0; k < 4; ++k) {
    const TaskStatus status = k < 2 ? TaskStatus::Done : TaskStatus::Enqueued;
    world.controller.onTask({7, k, {2, k}, {2, k + 1}, status}, world.now_s);
  }
  EXPECT_EQ(2, world.report().done);
  world.run(4.0);
  EXPECT_EQ(4, world.report().done);
  EXPECT_NEAR(1.35, world.x(), 0.005);
}

TEST(RobotControllerTest, ANewPlanGoesOnWhereTheOldOneEnded) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(1);
  world.run(2.5);
  EXPECT_EQ(TaskVerdict::Accepted,
            world.controller.onTask({2, 0, {2, 1}, {1, 1}}, world.now_s).verdict);
  world.executed_plan_id = 2;
  world.run(2.5);
  EXPECT_EQ(2U, world.report().plan_id);
  EXPECT_EQ(1, world.report().done);
  EXPECT_NEAR(1.05, world.pose.y_m, 0.005);
}

TEST(RobotControllerTest, GoingDownRampsToZero) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  Twist2d command;
  for (int tick = 0; tick < 15; ++tick) {
    world.now_s += 0.02;
    command = world.controller.rampDown(world.now_s);
  }
  EXPECT_DOUBLE_EQ(0.0, speed(command));
}

}  // namespace
}  // namespace sylph
