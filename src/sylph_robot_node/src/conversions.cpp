#include "sylph_robot_node/conversions.hpp"

#include <cmath>
#include <limits>

#include "sylph_core/grid/action.hpp"
#include "sylph_ros/conversions.hpp"

namespace sylph_robot_node {
namespace {

constexpr double kSameCenter_m = 0.001;

bool isCenter(const geometry_msgs::Point& point, const sylph::Cell& cell,
              const sylph::CellFrame& frame) {
  const double off_m = sylph::distance({point.x, point.y}, frame.toPoint(cell));
  return off_m < kSameCenter_m;  // false as well if it is not a number
}

}  // namespace

std::optional<sylph::AssignedTask> fromMessage(const sylph_msgs::Task& message,
                                               const sylph::CellFrame& frame, std::string& reason) {
  const sylph::Cell start = sylph_ros::fromMessage(message.start_cell);
  const sylph::Cell end = sylph_ros::fromMessage(message.end_cell);
  const auto action = sylph_ros::actionFromMessage(message.action);
  const std::string name = "task " + std::to_string(message.task_id) + " of plan " +
                           std::to_string(message.plan_id) + ": ";
  if (message.status != sylph_msgs::Task::ENQUEUED && message.status != sylph_msgs::Task::DONE) {
    reason = name + "status " + std::to_string(message.status) + ": must be ENQUEUED or DONE";
    return std::nullopt;
  }
  if (!action || *action == sylph::Action::Stay || sylph::neighbor(start, *action) != end) {
    reason = name + "action " + std::to_string(message.action) + " does not lead from " +
             toString(start) + " to " + toString(end);
    return std::nullopt;
  }
  if (!isCenter(message.start_pos, start, frame) || !isCenter(message.end_pos, end, frame)) {
    reason = name + "positions are not the centres of " + toString(start) + " and " +
             toString(end) + ": the robot has another map or cell size";
    return std::nullopt;
  }
  return sylph::AssignedTask{message.plan_id, message.sequence, start, end,
                             message.status == sylph_msgs::Task::DONE};
}

sylph::Pose2d fromMessage(const geometry_msgs::Pose& message) {
  const geometry_msgs::Quaternion& q = message.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const bool is_rotation = norm > 0.9 && norm < 1.1;
  return {message.position.x, message.position.y,
          is_rotation ? sylph_ros::yawOf(q) : std::numeric_limits<double>::quiet_NaN()};
}

std::optional<sylph::CentralMode> modeFromMessage(const sylph_msgs::AdgState& message) {
  switch (message.mode) {
    case sylph_msgs::AdgState::RUN:
      return sylph::CentralMode::Run;
    case sylph_msgs::AdgState::PAUSE:
      return sylph::CentralMode::Pause;
    case sylph_msgs::AdgState::STOP:
      return sylph::CentralMode::Stop;
    default:
      return std::nullopt;
  }
}

geometry_msgs::Twist toMessage(const sylph::Twist2d& twist_robot) {
  geometry_msgs::Twist message;
  message.linear.x = twist_robot.x_mps;
  message.linear.y = twist_robot.y_mps;
  message.angular.z = twist_robot.turn_radps;
  return message;
}

sylph_msgs::TaskReport toMessage(const sylph::RobotStatus& status) {
  sylph_msgs::TaskReport message;
  message.plan_id = status.plan_id;
  message.accepted = static_cast<std::uint32_t>(status.accepted);
  message.done = static_cast<std::uint32_t>(status.done);
  message.state = static_cast<std::uint8_t>(status.state);
  message.detail = status.detail;
  message.x = status.pose.x_m;
  message.y = status.pose.y_m;
  message.yaw = status.pose.yaw_rad;
  message.tracking_error_m = status.tracking_error_m;
  message.heading_error_rad = status.heading_error_rad;
  message.pose_age_s = status.pose_age_s;
  return message;
}

}  // namespace sylph_robot_node
