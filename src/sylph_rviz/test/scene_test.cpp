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

}  // namespace
}  // namespace sylph_rviz
