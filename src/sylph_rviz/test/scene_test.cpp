#include "sylph_rviz/scene.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include "test_scene.hpp"

namespace sylph_rviz {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

class StatusTest : public ::testing::Test {
 protected:
  StatusTest() {
    state.plan_id = 1;
    robot.tasks_total = 2;
    robot.task_status = sylph_msgs::Task::ENQUEUED;
  }
  AdgState state;
  RobotExecution robot;
};

TEST_F(StatusTest, IsUnknownBeforeThereIsAPlan) {
  state.plan_id = 0;
  EXPECT_EQ(RobotStatus::Unknown, statusOf(state, robot));
}

TEST_F(StatusTest, IsEnqueuedWhenTheCurrentTaskIsReleased) {
  EXPECT_EQ(RobotStatus::Enqueued, statusOf(state, robot));
}

TEST_F(StatusTest, IsStagedWhenTheCurrentTaskWaitsOrIsNotReleased) {
  robot.task_status = sylph_msgs::Task::STAGED;
  EXPECT_EQ(RobotStatus::Staged, statusOf(state, robot));
  robot.task_status = sylph_msgs::Task::ENQUEUED;
  robot.waiting = 1;
  EXPECT_EQ(RobotStatus::Staged, statusOf(state, robot));
}

TEST_F(StatusTest, IsDoneWithTheLastTask) {
  robot.tasks_done = 2;
  EXPECT_EQ(RobotStatus::Done, statusOf(state, robot));
}

TEST_F(StatusTest, IsHeldWhileTheMissionIsPausedOrTheRobotHolds) {
  state.mode = AdgState::PAUSE;
  EXPECT_EQ(RobotStatus::Held, statusOf(state, robot));
  state.mode = AdgState::RUN;
  robot.report_state = sylph_msgs::TaskReport::HOLDING;
  EXPECT_EQ(RobotStatus::Held, statusOf(state, robot));
}

TEST_F(StatusTest, FaultComesBeforeAllElse) {
  robot.tasks_done = 2;
  for (const std::uint8_t condition : {RobotExecution::SILENT, RobotExecution::STUCK,
                                       RobotExecution::BLIND, RobotExecution::LOST}) {
    robot.condition = condition;
    EXPECT_EQ(RobotStatus::Fault, statusOf(state, robot));
    EXPECT_FALSE(conditionName(robot).empty());
  }
  robot.condition = RobotExecution::OK;
  EXPECT_EQ("", conditionName(robot));
}

TEST(ShortNameTest, IsWhatFollowsTheLastUnderscore) {
  EXPECT_EQ("12", shortName("robot_12"));
  EXPECT_EQ("b", shortName("lab_robot_b"));
  EXPECT_EQ("anna", shortName("anna"));
  EXPECT_EQ("odd_", shortName("odd_"));
}

TEST(CenterOfTest, CountsRowsFromTheTopAndNeedsTheMap) {
  Scene scene = twoRobots();
  const auto center = centerOf(scene, {0, 1});
  ASSERT_TRUE(center);
  EXPECT_DOUBLE_EQ(0.45, center->x);
  EXPECT_DOUBLE_EQ(1.05, center->y);
  scene.map.reset();
  EXPECT_FALSE(centerOf(scene, {0, 1}));
}

TEST(WaitChainTest, EndsWhereNobodyWaitsAndWhereItClosesARing) {
  Scene scene = twoRobots();
  EXPECT_TRUE(waitChain(scene, "robot_9").empty());
  EXPECT_EQ(1U, waitChain(scene, "robot_0").size());
  for (std::size_t i = 0; i < 2; ++i) {
    scene.robots[i].execution->waiting = 1;
    scene.robots[i].execution->waits_for_robot = scene.robots[1 - i].name;
  }
  EXPECT_EQ(
      (std::vector<const RobotView*>{findRobot(scene, "robot_1"), findRobot(scene, "robot_0")}),
      waitChain(scene, "robot_1"));
}

TEST(PlannedPathTest, IsThePlansWithoutWaitsAndElseWhatIsLeft) {
  Scene scene = twoRobots();
  EXPECT_EQ(4U, plannedPath(scene, scene.robots[0]).size());
  scene.plan.emplace();
  scene.plan->plan_id = 1;
  scene.plan->robots = {"robot_1", "robot_0"};
  scene.plan->plan = {{{3, 4}, {3, 0}}, {{3, 4}, {3, 0}}, {{3, 4}, {3, 1}}};
  EXPECT_EQ((std::vector<sylph::Cell>{{3, 0}, {3, 1}}), plannedPath(scene, scene.robots[0]));
  scene.plan->plan_id = 7;
  EXPECT_EQ(4U, plannedPath(scene, scene.robots[0]).size()) << "another plan's";
}

TEST(SetPoseTest, KeepsWhereARobotHasBeenUntilTheNextPlan) {
  Scene scene = twoRobots();
  sylph_msgs::AdgState state = *scene.state;
  for (const double x : {0.1, 0.105, 0.2}) {
    setPose(scene.robots[0], {x, 0.0, 0.0});
  }
  ASSERT_EQ(2U, scene.robots[0].driven.size()) << "not where it stands all but still";
  EXPECT_DOUBLE_EQ(0.2, scene.robots[0].driven.back().x);
  state.elapsed_s = 3.0;
  setState(scene, state);
  EXPECT_EQ(2U, scene.robots[0].driven.size());
  state.elapsed_s = 1.0;
  setState(scene, state);
  EXPECT_TRUE(scene.robots[0].driven.empty()) << "a replay that begins again";
  setPose(scene.robots[0], {0.3, 0.0, 0.0});
  state.plan_id = 2;
  setState(scene, state);
  EXPECT_TRUE(scene.robots[0].driven.empty());
}

}  // namespace
}  // namespace sylph_rviz
