#include "sylph_ros/state_messages.hpp"

#include <gtest/gtest.h>

#include "sylph_ros/conversions.hpp"

namespace sylph_ros {
namespace {

sylph::AdgState state() {
  sylph::RobotExecution robot;
  robot.robot = "alpha";
  robot.condition = sylph::RobotCondition::Stuck;
  robot.report_state = sylph::RobotState::Moving;
  robot.tasks_total = 7;
  robot.tasks_done = 3;
  robot.step = 12;
  robot.task_id = 21;
  robot.task_status = sylph::TaskStatus::Enqueued;
  robot.action = sylph::Action::East;
  robot.cell = {4, 4};
  robot.next_cell = {4, 5};
  robot.goal = {4, 9};
  robot.held_cells = {{4, 4}, {4, 5}};
  robot.remaining_path = {{4, 4}, {4, 5}, {4, 6}};
  robot.partner = "cf1";
  robot.svo_deg = 25.0F;
  robot.waits_for_robot = "robot_1";
  robot.waits_for_task = 17;
  robot.waits_for_cell = {4, 5};
  robot.waited_s = 2.5;
  robot.is_aligning = true;
  robot.root_cause_robot = "robot_2";
  robot.root_cause = "no report for 3.0 s";
  sylph::AdgState state;
  state.plan_id = 3;
  state.last_plan_id = 5;
  state.executed_plan_id = 4;
  state.phase = sylph::ExecutionPhase::Cutting;
  state.mode = sylph::ExecutionMode::Pause;
  state.message = "by the operator";
  state.steps = 40;
  state.elapsed_s = 8.25;
  state.robots = {robot};
  return state;
}

TEST(StateMessagesTest, AStateThereAndBackIsTheIdentity) {
  const sylph_msgs::AdgState message = toMessage(state());
  EXPECT_EQ("map", message.header.frame_id);
  EXPECT_TRUE(message.robots.front().waiting);
  const auto back = fromMessage(message);
  ASSERT_TRUE(back);
  EXPECT_EQ(3U, back->plan_id);
  EXPECT_EQ(5U, back->last_plan_id);
  EXPECT_EQ(4U, back->executed_plan_id);
  EXPECT_EQ(sylph::ExecutionPhase::Cutting, back->phase);
  EXPECT_EQ(sylph::ExecutionMode::Pause, back->mode);
  EXPECT_EQ("by the operator", back->message);
  EXPECT_EQ(40U, back->steps);
  EXPECT_EQ(8.25, back->elapsed_s);
  ASSERT_EQ(1U, back->robots.size());
  const sylph::RobotExecution expected = state().robots.front();
  const sylph::RobotExecution& robot = back->robots.front();
  EXPECT_EQ("alpha", robot.robot);
  EXPECT_EQ(expected.condition, robot.condition);
  EXPECT_EQ(expected.report_state, robot.report_state);
  EXPECT_EQ(7, robot.tasks_total);
  EXPECT_EQ(3, robot.tasks_done);
  EXPECT_EQ(12, robot.step);
  EXPECT_EQ(21, robot.task_id);
  EXPECT_EQ(expected.task_status, robot.task_status);
  EXPECT_EQ(expected.action, robot.action);
  EXPECT_EQ(expected.cell, robot.cell);
  EXPECT_EQ(expected.next_cell, robot.next_cell);
  EXPECT_EQ(expected.goal, robot.goal);
  EXPECT_EQ(expected.held_cells, robot.held_cells);
  EXPECT_EQ(expected.remaining_path, robot.remaining_path);
  EXPECT_EQ("cf1", robot.partner);
  EXPECT_EQ(25.0F, robot.svo_deg);
  EXPECT_EQ("robot_1", robot.waits_for_robot);
  EXPECT_EQ(17, robot.waits_for_task);
  EXPECT_EQ(expected.waits_for_cell, robot.waits_for_cell);
  EXPECT_EQ(2.5, robot.waited_s);
  EXPECT_TRUE(robot.is_aligning);
  EXPECT_EQ("robot_2", robot.root_cause_robot);
  EXPECT_EQ("no report for 3.0 s", robot.root_cause);
}

TEST(StateMessagesTest, AStateThatMakesNoSenseIsNone) {
  sylph_msgs::AdgState message = toMessage(state());
  message.phase = 7;
  EXPECT_FALSE(fromMessage(message));
  message = toMessage(state());
  message.mode = 3;
  EXPECT_FALSE(fromMessage(message));
  EXPECT_FALSE(modeFromMessage(message));
  message = toMessage(state());
  message.robots.front().condition = 5;
  EXPECT_FALSE(fromMessage(message));
  message = toMessage(state());
  message.robots.front().action = 5;
  EXPECT_FALSE(fromMessage(message));
  message = toMessage(state());
  message.robots.front().tasks_done = 8;
  EXPECT_FALSE(fromMessage(message)) << "more done than there are";
}

}  // namespace
}  // namespace sylph_ros
