#include "sylph_adg_central/conversions.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/AgentAction.h>

#include <limits>

#include "sylph_ros/conversions.hpp"

namespace sylph_adg_central {
namespace {

using sylph_msgs::TaskReport;

TEST(ConversionsTest, ATaskCarriesAllThatItsRobotNeeds) {
  sylph::TaskOrder order;
  order.plan_id = 4;
  order.sequence = 2;
  order.robot_tasks = 9;
  order.task.id = 17;
  order.task.timestep = 5;
  order.task.action = sylph::Action::North;
  order.task.start = {2, 1};
  order.task.end = {1, 1};
  order.status = sylph::TaskStatus::Done;
  order.dependencies = {11, 16};
  const sylph_msgs::Task task = toMessage(order, "robot_3", sylph::CellFrame(4, 0.5));
  EXPECT_EQ("map", task.header.frame_id);
  EXPECT_EQ("robot_3", task.robot_id);
  EXPECT_EQ(4u, task.plan_id);
  EXPECT_EQ(17u, task.task_id);
  EXPECT_EQ(2u, task.sequence);
  EXPECT_EQ(9u, task.robot_tasks);
  EXPECT_EQ(5u, task.time);
  EXPECT_EQ(sylph_msgs::AgentAction::NORTH, task.action);
  EXPECT_EQ((sylph::Cell{2, 1}), sylph_ros::fromMessage(task.start_cell));
  EXPECT_EQ((sylph::Cell{1, 1}), sylph_ros::fromMessage(task.end_cell));
  EXPECT_NEAR(0.75, task.start_pos.x, 1e-12);
  EXPECT_NEAR(0.75, task.start_pos.y, 1e-12);
  EXPECT_NEAR(1.25, task.end_pos.y, 1e-12);
  EXPECT_EQ((std::vector<std::uint32_t>{11, 16}), task.dependencies);
  EXPECT_EQ(sylph_msgs::Task::DONE, task.status);
}

TEST(ConversionsTest, AReportThatMakesNoSenseIsNone) {
  TaskReport message;
  message.accepted = 3;
  message.done = 2;
  message.state = TaskReport::MOVING;
  message.x = 1.5;
  ASSERT_TRUE(fromMessage(message).has_value());
  EXPECT_EQ(1.5, fromMessage(message)->position->x);
  EXPECT_EQ(sylph::ReportState::Moving, fromMessage(message)->state);
  message.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fromMessage(message)->position.has_value());
  message.done = 4;
  EXPECT_FALSE(fromMessage(message).has_value()) << "more done than accepted";
  message.done = 0;
  message.state = 9;
  EXPECT_FALSE(fromMessage(message).has_value());
  message.state = TaskReport::IDLE;
  message.accepted = 4000000000U;
  EXPECT_FALSE(fromMessage(message).has_value());
}

TEST(ConversionsTest, AViewTellsWhyARobotWaits) {
  sylph::RobotView view;
  view.task = sylph::Task();
  view.task->id = 3;
  view.task->end = {4, 5};
  view.cell = {4, 4};
  view.tasks_total = 2;
  view.waits_for_robot = "robot_1";
  view.waits_for_cell = {4, 5};
  view.waiting_since_s = 2.5;
  view.root_cause_robot = "robot_2";
  view.root_cause = "no report for 3.0 s";
  const sylph_msgs::RobotExecution message = toMessage(view, "robot_0");
  EXPECT_EQ("robot_0", message.robot_id);
  EXPECT_TRUE(message.waiting);
  EXPECT_EQ("robot_1", message.waits_for_robot);
  EXPECT_EQ(2.5, message.waiting_since_s);
  EXPECT_EQ("robot_2", message.root_cause_robot);
  EXPECT_EQ((sylph::Cell{4, 5}), sylph_ros::fromMessage(message.next_cell));
  view.task.reset();
  EXPECT_EQ((sylph::Cell{4, 4}), sylph_ros::fromMessage(toMessage(view, "robot_0").next_cell));
}

}  // namespace
}  // namespace sylph_adg_central
