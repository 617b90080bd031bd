#include "mock_lab.hpp"

#include <std_msgs/Bool.h>
#include <sylph_msgs/AdgState.h>

#include "sylph_core/grid/action.hpp"
#include "sylph_ros/conversions.hpp"

namespace sylph_robot_node {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kLag_s = 0.08;

}  // namespace

MockLab::MockLab(const sylph::Cell& start) {
  pose_ = {frame_.toPoint(start).x, frame_.toPoint(start).y, 0.0};
  pose_publisher_ = nh_.advertise<geometry_msgs::PoseStamped>("pose", 1);
  task_publisher_ = nh_.advertise<sylph_msgs::Task>("task", 100);
  state_publisher_ = nh_.advertise<sylph_msgs::AdgState>("/sylph/adg_state", 1);
  emergency_publisher_ = nh_.advertise<std_msgs::Bool>("/sylph/emergency_stop", 1, true);
  command_subscriber_ = nh_.subscribe<geometry_msgs::Twist>(
      "cmd_vel", 100, [this](const geometry_msgs::TwistConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        command_ = *message;
        ++commands_;
      });
  report_subscriber_ = nh_.subscribe<sylph_msgs::TaskReport>(
      "task_report", 100, [this](const sylph_msgs::TaskReportConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        report_ = *message;
      });
  timer_ = nh_.createWallTimer(ros::WallDuration(kStep_s), [this](const auto&) { step(); });
  spinner_.start();
}

void MockLab::step() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const sylph::Twist2d target = sylph::mapFromRobot(
      {command_.linear.x, command_.linear.y, command_.angular.z}, pose_.yaw_rad);
  twist_.x_mps += kStep_s / kLag_s * (target.x_mps - twist_.x_mps);
  twist_.y_mps += kStep_s / kLag_s * (target.y_mps - twist_.y_mps);
  pose_.x_m += kStep_s * twist_.x_mps;
  pose_.y_m += kStep_s * twist_.y_mps;
  pose_.yaw_rad += kStep_s * target.turn_radps;
  if (cameras_on_) {
    geometry_msgs::PoseStamped message;
    message.header.stamp = ros::Time::now();
    message.header.frame_id = "map";
    message.pose.position.x = pose_.x_m + camera_offset_m_ + (steps_ % 2 == 0 ? 1e-4 : -1e-4);
    message.pose.position.y = pose_.y_m;
    message.pose.orientation = sylph_ros::quaternionFromYaw(pose_.yaw_rad);
    pose_publisher_.publish(message);
  }
  if (central_on_ && steps_ % 10 == 0) {
    sylph_msgs::AdgState state;
    state.header.stamp = ros::Time::now();
    state.mode = mode_;
    state.executed_plan_id = executed_plan_id_;
    state.robots.resize(1);
    state.robots[0].robot_id = "robot_0";
    state.robots[0].aligning = static_cast<std::uint8_t>(aligning_on_);
    state_publisher_.publish(state);
    ++states_;
  }
  ++steps_;
}

void MockLab::sendTask(std::uint32_t plan, std::uint32_t sequence, const sylph::Cell& from,
                       const sylph::Cell& to) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    executed_plan_id_ = plan;
  }
  sylph_msgs::Task task;
  task.header.frame_id = "map";
  task.plan_id = plan;
  task.task_id = sequence;
  task.sequence = sequence;
  task.robot_id = "robot_0";
  task.action = sylph_ros::toMessage(sylph::actionBetween(from, to).value());
  task.start_cell = sylph_ros::toMessage(from);
  task.end_cell = sylph_ros::toMessage(to);
  task.start_pos = sylph_ros::toMessage(frame_.toPoint(from));
  task.end_pos = sylph_ros::toMessage(frame_.toPoint(to));
  task.status = sylph_msgs::Task::ENQUEUED;
  task_publisher_.publish(task);
}

void MockLab::setEmergency(bool is_pressed) {
  std_msgs::Bool message;
  message.data = static_cast<std::uint8_t>(is_pressed);
  emergency_publisher_.publish(message);
}

void MockLab::setMode(std::uint8_t mode) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mode_ = mode;
}

void MockLab::setCameras(bool on) {
  const std::lock_guard<std::mutex> lock(mutex_);
  cameras_on_ = on;
}

void MockLab::setCameraOffset(double offset_m) {
  const std::lock_guard<std::mutex> lock(mutex_);
  camera_offset_m_ = offset_m;
}

void MockLab::setCentral(bool on) {
  const std::lock_guard<std::mutex> lock(mutex_);
  central_on_ = on;
}

void MockLab::turn(double angle_rad) {
  const std::lock_guard<std::mutex> lock(mutex_);
  pose_.yaw_rad += angle_rad;
}

void MockLab::setAligning(bool on) {
  const std::lock_guard<std::mutex> lock(mutex_);
  aligning_on_ = on;
}

sylph_msgs::TaskReport MockLab::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_;
}

geometry_msgs::Twist MockLab::command() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return command_;
}

sylph::Pose2d MockLab::pose() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return pose_;
}

std::size_t MockLab::commandCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return commands_;
}

int MockLab::stateCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return states_;
}

bool MockLab::isConnected() const {
  return pose_publisher_.getNumSubscribers() > 0 && task_publisher_.getNumSubscribers() > 0 &&
         state_publisher_.getNumSubscribers() > 0 && emergency_publisher_.getNumSubscribers() > 0 &&
         hasCommander() && report_subscriber_.getNumPublishers() > 0;
}

}  // namespace sylph_robot_node
