#include "sylph_ros/task_messages.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/AgentAction.h>

#include <limits>
#include <string>

#include "sylph_ros/conversions.hpp"

namespace sylph_ros {
namespace {

using sylph_msgs::AgentAction;
using sylph_msgs::TaskReport;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const sylph::CellFrame kFrame(4, 0.5);

sylph::TaskOrder order() {
  sylph::TaskOrder order;
  order.plan_id = 4;
  order.sequence = 2;
  order.start = {2, 1};
  order.end = {1, 1};
  order.status = sylph::TaskStatus::Done;
  order.robot_tasks = 9;
  order.task_id = 17;
  order.timestep = 5;
  order.dependencies = {11, 16};
  return order;
}

std::string refusalOf(const sylph_msgs::Task& message) {
  std::string reason;
  EXPECT_FALSE(fromMessage(message, kFrame, reason));
  return reason;
}

TEST(TaskMessagesTest, AnOrderThereAndBackIsTheIdentity) {
  std::string reason;
  const auto back = fromMessage(toMessage(order(), "robot_3", kFrame), kFrame, reason);
  ASSERT_TRUE(back) << reason;
  EXPECT_TRUE(sylph::isSameTask(order(), *back));
  EXPECT_EQ(sylph::TaskStatus::Done, back->status);
  EXPECT_EQ(9, back->robot_tasks);
  EXPECT_EQ(17, back->task_id);
  EXPECT_EQ(5, back->timestep);
  EXPECT_EQ((std::vector<sylph::TaskId>{11, 16}), back->dependencies);
}

TEST(TaskMessagesTest, ATaskTellsTheReaderWhoGoesWhere) {
  const sylph_msgs::Task task = toMessage(order(), "robot_3", kFrame);
  EXPECT_EQ("map", task.header.frame_id);
  EXPECT_EQ("robot_3", task.robot_id);
  EXPECT_EQ(AgentAction::NORTH, task.action);
  EXPECT_NEAR(0.75, task.start_pos.x, 1e-12);
  EXPECT_NEAR(0.75, task.start_pos.y, 1e-12);
  EXPECT_NEAR(1.25, task.end_pos.y, 1e-12);
}

TEST(TaskMessagesTest, ATaskThatContradictsItselfIsRefused) {
  sylph_msgs::Task message = toMessage(order(), "robot_3", kFrame);
  message.action = AgentAction::EAST;
  EXPECT_EQ("task 17 of plan 4: action 2 does not lead from (2,1) to (1,1)", refusalOf(message));
  message.action = 9;
  EXPECT_NE(std::string::npos, refusalOf(message).find("action 9"));
  message.action = AgentAction::STAY;
  message.end_cell = message.start_cell;
  message.end_pos = message.start_pos;
  EXPECT_NE(std::string::npos, refusalOf(message).find("action 0"));
  message = toMessage(order(), "robot_3", kFrame);
  message.status = sylph_msgs::Task::STAGED;
  EXPECT_NE(std::string::npos, refusalOf(message).find("status 0"));
  message = toMessage(order(), "robot_3", kFrame);
  message.sequence = 4000000000U;
  EXPECT_NE(std::string::npos, refusalOf(message).find("sequence"));
}

TEST(TaskMessagesTest, ATaskOfAnotherMapOrCellSizeIsRefused) {
  sylph_msgs::Task message = toMessage(order(), "robot_3", kFrame);
  message.end_pos.x += 0.05;
  EXPECT_NE(std::string::npos, refusalOf(message).find("another map or cell size"));
  message = toMessage(order(), "robot_3", kFrame);
  message.start_pos.y = kNaN;
  EXPECT_NE(std::string::npos, refusalOf(message).find("centres"));
}

TEST(TaskMessagesTest, AReportThereAndBackIsTheIdentity) {
  sylph::RobotReport report;
  report.report_id = 12;
  report.plan_id = 3;
  report.accepted = 5;
  report.done = 2;
  report.state = sylph::RobotState::Blind;
  report.detail = "pose is not finite";
  report.pose = {1.0, 2.0, 0.5};
  report.tracking_error_m = 0.004;
  report.heading_error_rad = -0.01;
  report.pose_age_s = 0.2;
  TaskReport message = toMessage(report);
  message.header.stamp.fromSec(7.5);
  const auto back = fromMessage(message);
  ASSERT_TRUE(back);
  EXPECT_TRUE(sylph::tellTheSame(report, *back));
  EXPECT_EQ(12U, back->report_id);
  EXPECT_EQ(7.5, back->stamp_s);
  EXPECT_EQ("pose is not finite", back->detail);
  ASSERT_TRUE(back->pose);
  EXPECT_EQ(1.0, back->pose->x_m);
  EXPECT_EQ(2.0, back->pose->y_m);
  EXPECT_EQ(0.5, back->pose->yaw_rad);
  EXPECT_EQ(0.004, back->tracking_error_m);
  EXPECT_EQ(-0.01, back->heading_error_rad);
  EXPECT_EQ(0.2, back->pose_age_s);
  report.pose.reset();
  EXPECT_FALSE(fromMessage(toMessage(report))->pose.has_value());
}

TEST(TaskMessagesTest, AReportThatMakesNoSenseIsNone) {
  TaskReport message;
  message.accepted = 3;
  message.done = 2;
  message.state = TaskReport::MOVING;
  ASSERT_TRUE(fromMessage(message));
  EXPECT_TRUE(fromMessage(message)->pose.has_value());
  message.x = kNaN;
  EXPECT_FALSE(fromMessage(message)->pose.has_value());
  message.done = 4;
  EXPECT_FALSE(fromMessage(message)) << "more done than accepted";
  message.done = 0;
  message.state = 9;
  EXPECT_FALSE(fromMessage(message));
  message.state = TaskReport::IDLE;
  message.accepted = 4000000000U;
  EXPECT_FALSE(fromMessage(message));
}

}  // namespace
}  // namespace sylph_ros
