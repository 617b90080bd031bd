#include "sylph_robot_node/conversions.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/AgentAction.h>

#include <cmath>
#include <limits>
#include <string>

#include "sylph_ros/conversions.hpp"

namespace sylph_robot_node {
namespace {

const sylph::CellFrame kFrame(3, 0.3);

sylph_msgs::Task taskMessage() {
  sylph_msgs::Task message;
  message.plan_id = 4;
  message.task_id = 17;
  message.sequence = 2;
  message.action = sylph_msgs::AgentAction::EAST;
  message.start_cell = sylph_ros::toMessage(sylph::Cell{0, 1});
  message.end_cell = sylph_ros::toMessage(sylph::Cell{0, 2});
  message.start_pos = sylph_ros::toMessage(kFrame.toPoint({0, 1}));
  message.end_pos = sylph_ros::toMessage(kFrame.toPoint({0, 2}));
  message.status = sylph_msgs::Task::ENQUEUED;
  return message;
}

std::string refusalOf(const sylph_msgs::Task& message) {
  std::string reason;
  EXPECT_FALSE(fromMessage(message, kFrame, reason));
  return reason;
}

TEST(ConversionsTest, ATaskKeepsPlanSequenceCellsAndStatus) {
  std::string reason;
  auto task = fromMessage(taskMessage(), kFrame, reason);
  ASSERT_TRUE(task) << reason;
  EXPECT_EQ((sylph::AssignedTask{4, 2, {0, 1}, {0, 2}, false}), *task);
  EXPECT_FALSE(task->is_done);
  sylph_msgs::Task done = taskMessage();
  done.status = sylph_msgs::Task::DONE;
  task = fromMessage(done, kFrame, reason);
  ASSERT_TRUE(task);
  EXPECT_TRUE(task->is_done);
}

TEST(ConversionsTest, ATaskThatContradictsItselfIsRefused) {
  sylph_msgs::Task message = taskMessage();
  message.action = sylph_msgs::AgentAction::NORTH;
  EXPECT_NE(std::string::npos, refusalOf(message).find("action 1 does not lead"));
  message = taskMessage();
  message.action = 9;
  EXPECT_NE(std::string::npos, refusalOf(message).find("action 9"));
  message = taskMessage();
  message.action = sylph_msgs::AgentAction::STAY;
  message.end_cell = message.start_cell;
  message.end_pos = message.start_pos;
  EXPECT_NE(std::string::npos, refusalOf(message).find("action 0"));
  message = taskMessage();
  message.status = sylph_msgs::Task::STAGED;
  EXPECT_NE(std::string::npos, refusalOf(message).find("status 0"));
}

TEST(ConversionsTest, ATaskOfAnotherMapOrCellSizeIsRefused) {
  sylph_msgs::Task message = taskMessage();
  message.end_pos.x += 0.05;
  EXPECT_NE(std::string::npos, refusalOf(message).find("another map or cell size"));
  message = taskMessage();
  message.start_pos.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(std::string::npos, refusalOf(message).find("centres"));
}

TEST(ConversionsTest, APoseKeepsPositionAndYaw) {
  geometry_msgs::Pose message;
  message.position.x = 1.5;
  message.position.y = -0.5;
  message.orientation = sylph_ros::quaternionFromYaw(2.0);
  const sylph::Pose2d pose = fromMessage(message);
  EXPECT_DOUBLE_EQ(1.5, pose.x_m);
  EXPECT_DOUBLE_EQ(-0.5, pose.y_m);
  EXPECT_NEAR(2.0, pose.yaw_rad, 1e-12);
}

TEST(ConversionsTest, APoseWithoutARotationIsNotFinite) {
  geometry_msgs::Pose message;  // all zeros
  EXPECT_FALSE(sylph::isFinite(fromMessage(message)));
  message.orientation.w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(sylph::isFinite(fromMessage(message)));
}

TEST(ConversionsTest, ModesOutsideTheMessagesConstantsAreNone) {
  sylph_msgs::AdgState message;
  message.mode = sylph_msgs::AdgState::PAUSE;
  EXPECT_EQ(sylph::CentralMode::Pause, modeFromMessage(message));
  message.mode = 7;
  EXPECT_FALSE(modeFromMessage(message));
}

TEST(ConversionsTest, ATwistIsInTheBaseFrame) {
  const geometry_msgs::Twist message = toMessage(sylph::Twist2d{0.1, -0.2, 0.3});
  EXPECT_DOUBLE_EQ(0.1, message.linear.x);
  EXPECT_DOUBLE_EQ(-0.2, message.linear.y);
  EXPECT_DOUBLE_EQ(0.3, message.angular.z);
}

TEST(ConversionsTest, AReportTellsTheStatus) {
  sylph::RobotStatus status;
  status.state = sylph::RobotState::Blind;
  status.detail = "pose is not finite";
  status.plan_id = 3;
  status.accepted = 5;
  status.done = 2;
  status.pose = {1.0, 2.0, 0.5};
  status.tracking_error_m = 0.004;
  status.heading_error_rad = -0.01;
  status.pose_age_s = 0.2;
  const sylph_msgs::TaskReport message = toMessage(status);
  EXPECT_EQ(sylph_msgs::TaskReport::BLIND, message.state);
  EXPECT_EQ("pose is not finite", message.detail);
  EXPECT_EQ(3u, message.plan_id);
  EXPECT_EQ(5u, message.accepted);
  EXPECT_EQ(2u, message.done);
  EXPECT_DOUBLE_EQ(1.0, message.x);
  EXPECT_DOUBLE_EQ(2.0, message.y);
  EXPECT_DOUBLE_EQ(0.5, message.yaw);
  EXPECT_DOUBLE_EQ(0.004, message.tracking_error_m);
  EXPECT_DOUBLE_EQ(-0.01, message.heading_error_rad);
  EXPECT_DOUBLE_EQ(0.2, message.pose_age_s);
}

TEST(ConversionsTest, StatesHaveTheNumbersOfTheMessage) {
  EXPECT_EQ(sylph_msgs::TaskReport::IDLE, static_cast<int>(sylph::RobotState::Idle));
  EXPECT_EQ(sylph_msgs::TaskReport::MOVING, static_cast<int>(sylph::RobotState::Moving));
  EXPECT_EQ(sylph_msgs::TaskReport::HOLDING, static_cast<int>(sylph::RobotState::Holding));
  EXPECT_EQ(sylph_msgs::TaskReport::BLIND, static_cast<int>(sylph::RobotState::Blind));
}

}  // namespace
}  // namespace sylph_robot_node
