#include "sylph_core/control/robot_controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "robot_world.hpp"
#include "sylph_core/control/drive_path.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"

namespace sylph {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

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

TEST(RobotControllerTest, MakesUpForSlip) {
  RobotWorld world({2, 0});
  world.grip = 0.93;
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.5);
  const double x_m = world.x();
  world.run(1.0);
  EXPECT_NEAR(0.25, world.x() - x_m, 0.003);
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

TEST(RobotControllerTest, RampsToZeroWithoutPosesAndGoesOnByItself) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.cameras_send = false;
  world.run(0.1);
  EXPECT_GT(world.speedNow(), 0.2);
  world.run(0.06);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.run(0.25);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.cameras_send = true;
  world.run(4.0);
  EXPECT_EQ(4, world.report().done);
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
  double worst_m = 0.0;
  for (double after_s = 0.1; after_s < 6.0; after_s += 0.03) {
    SCOPED_TRACE(after_s);
    RobotWorld world(path.front());
    worst_m = std::max(worst_m, largestDeviation(world, path, after_s));
    EXPECT_EQ(4, world.report().done);  // and it goes on by itself
  }
  EXPECT_LT(worst_m, overrun_m);
  // The moments tried are the bad ones: a base that latches for half a second leaves its cells.
  RobotWorld latching(path.front());
  latching.base_timeout_s = 0.5;
  EXPECT_GT(largestDeviation(latching, path, 2.2), overrun_m);
}

TEST(RobotControllerTest, APoseThatIsNotFiniteStopsIt) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.camera_offset.x_m = kNaN;
  world.run(0.4);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_EQ("pose is not finite", world.report().detail);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
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

TEST(RobotControllerTest, ARobotCarriedAwayHoldsUntilItIsPutBack) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(1.0);
  world.loseSightFor(0.3);
  world.camera_offset.y_m = 0.5;
  world.run(0.5);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.stopAndResume();
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_NE(std::string::npos, world.report().detail.find("put it back"));
  world.loseSightFor(0.3);
  world.camera_offset.y_m = 0.0;
  world.run(0.3);
  world.stopAndResume();
  world.run(4.0);
  EXPECT_EQ(2, world.report().done);
}

TEST(RobotControllerTest, AJumpOfThePoseIsBelievedOnlyAfterStopAndResume) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(1.0);
  world.camera_offset.x_m = 0.1;
  world.run(2.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.mode = ExecutionMode::Stop;
  world.run(0.5);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.mode = ExecutionMode::Run;
  world.run(0.5);
  EXPECT_EQ(RobotState::Moving, world.report().state);
}

TEST(RobotControllerTest, ARobotWithoutATaskIsWherePeoplePutIt) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.loseSightFor(0.5);
  world.pose.x_m += 0.3;
  world.run(0.3);
  EXPECT_EQ(RobotState::Idle, world.report().state);
  EXPECT_NEAR(0.45, world.report().pose->x_m, 0.01);
}

TEST(RobotControllerTest, AFalsePlaceAfterAShortOcclusionMovesNoRobot) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.loseSightFor(0.12);
  world.camera_offset.y_m = 0.1;
  world.run(3.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_NEAR(0.75, world.pose.y_m, 0.005);
  world.camera_offset.y_m = 0.0;
  world.run(5.0);
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
  EXPECT_EQ(2u, world.report().plan_id);
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

TEST(RobotControllerTest, WhatTheCentralNodeSaidBeforeItsLastWordIsLate) {
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

TEST(RobotControllerTest, ABodyWithTurnedAxesStopsItSoon) {
  RobotWorld world({2, 1});
  world.run(0.2);
  for (int k = 0; k < 3; ++k) {
    world.controller.onTask({1, k, {2, k + 1}, {2, k + 2}}, world.now_s);
  }
  world.grip = -1.0;
  world.run(5.0);
  EXPECT_NE(std::string::npos, world.report().detail.find("exchanged or turned"))
      << world.report().detail;
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  EXPECT_LT(std::abs(world.x() - 0.45), 0.067);  // what lies between two robots in the lab
}

TEST(RobotControllerTest, ARobotWithTheBodyOfOneThatStandsIsSoonDrivenNoMore) {
  RobotWorld world({4, 4});
  world.other_body = Pose2d{0.15, 0.75, 0.0};  // in (2,0)
  world.run(0.2);
  world.sendEastward(4);
  world.run(12.0);
  EXPECT_NE(std::string::npos, world.report().detail.find("bodies exchanged"))
      << world.report().detail;
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  EXPECT_LT(world.x() - 1.35, 0.15);  // 3.1 m, if nobody looks
}

TEST(RobotControllerTest, APoseThatSlidesAwayIsNotFollowed) {
  for (const double slide_mps : {0.1, 0.3}) {
    SCOPED_TRACE(slide_mps);
    RobotWorld world({2, 0});
    world.run(0.2);
    world.sendEastward(1);
    world.run(4.0);
    ASSERT_EQ(1, world.report().done);
    for (double slid_m = 0.0; slid_m < 0.12; slid_m += 0.01 * slide_mps) {
      world.camera_offset.y_m = slid_m;
      world.run(0.01);
    }
    world.run(3.0);
    EXPECT_NE(std::string::npos, world.report().detail.find("otherwise than it is driven"))
        << world.report().detail;
    EXPECT_NEAR(0.75, world.pose.y_m, 0.067);
  }
}

TEST(RobotControllerTest, ABaseThatIsStuckForThreeSecondsGoesOnByItself) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(1.0);
  world.grip = 0.0;
  world.run(3.0);
  world.grip = 1.0;
  world.run(8.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, ABaseThatNeverAnswersIsCommandedNoMore) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.grip = 0.0;
  world.run(6.0);
  EXPECT_NE(std::string::npos, world.report().detail.find("base dead")) << world.report().detail;
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.grip = 1.0;
  world.stopAndResume();
  world.run(8.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, ARobotPushedWithinItsCellsReturnsToItsPath) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(1);
  world.run(0.5);
  world.loseSightFor(0.2);
  world.pose.y_m += 0.08;
  world.run(0.3);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.stopAndResume();
  world.run(4.0);
  EXPECT_EQ(1, world.report().done);
  EXPECT_LT(world.report().tracking_error_m, 0.01);
}

TEST(RobotControllerTest, AYawFlipNeverTurnsTheRobot) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(0.5);
  world.camera_offset.yaw_rad = M_PI;
  world.run(2.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_DOUBLE_EQ(0.0, world.command_robot.turn_radps);
  world.camera_offset.yaw_rad = 0.0;
  world.run(4.0);
  EXPECT_EQ(2, world.report().done);
}

TEST(RobotControllerTest, ARobotThatWasTurnedByHandWaitsToBeTurnedBack) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(0.5);
  world.loseSightFor(0.3);
  world.camera_offset.yaw_rad = 1.5;
  world.run(1.0);
  world.stopAndResume();
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_NE(std::string::npos, world.report().detail.find("heading"));
  EXPECT_DOUBLE_EQ(0.0, world.command_robot.turn_radps);
  world.loseSightFor(0.3);
  world.camera_offset.yaw_rad = 0.0;
  world.run(0.3);
  world.stopAndResume();
  world.run(4.0);
  EXPECT_EQ(2, world.report().done);
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
  EXPECT_EQ(2u, world.report().plan_id);
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
