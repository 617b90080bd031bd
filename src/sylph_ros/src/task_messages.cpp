#include "sylph_ros/task_messages.hpp"

#include <limits>

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/same_constants.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

using sylph_msgs::Task;
using sylph_msgs::TaskReport;

static_assert(isSame(sylph::RobotState::Idle, TaskReport::IDLE) &&
              isSame(sylph::RobotState::Moving, TaskReport::MOVING) &&
              isSame(sylph::RobotState::Holding, TaskReport::HOLDING) &&
              isSame(sylph::RobotState::Blind, TaskReport::BLIND));
static_assert(isSame(sylph::TaskStatus::Staged, Task::STAGED) &&
              isSame(sylph::TaskStatus::Enqueued, Task::ENQUEUED) &&
              isSame(sylph::TaskStatus::Done, Task::DONE));

constexpr double kSameCenter_m = 0.001;
constexpr auto kMaxCount = static_cast<std::uint32_t>(std::numeric_limits<int>::max());

bool isCenter(const geometry_msgs::Point& point, const sylph::Cell& cell,
              const sylph::CellFrame& frame) {
  const double off_m = sylph::distance({point.x, point.y}, frame.toPoint(cell));
  return off_m < kSameCenter_m;  // false as well if it is not a number
}

/// What is wrong with a task, empty if nothing is.
std::string faultOf(const Task& message, const sylph::CellFrame& frame) {
  const sylph::Cell start = fromMessage(message.start_cell);
  const sylph::Cell end = fromMessage(message.end_cell);
  if (message.status != Task::ENQUEUED && message.status != Task::DONE) {
    return "status " + std::to_string(message.status) + ": must be ENQUEUED or DONE";
  }
  if (message.sequence > kMaxCount || message.robot_tasks > kMaxCount) {
    return "sequence or robot_tasks: must be at most " + std::to_string(kMaxCount);
  }
  const auto action = actionFromMessage(message.action);
  if (!action || *action == sylph::Action::Stay || sylph::neighbor(start, *action) != end) {
    return "action " + std::to_string(message.action) + " does not lead from " + toString(start) +
           " to " + toString(end);
  }
  // The same place told twice: a robot whose copy of the experiment differs must not drive by it.
  if (!isCenter(message.start_pos, start, frame) || !isCenter(message.end_pos, end, frame)) {
    return "positions are not the centres of " + toString(start) + " and " + toString(end) +
           ": the robot has another map or cell size";
  }
  return {};
}

}  // namespace

Task toMessage(const sylph::TaskOrder& order, const std::string& robot,
               const sylph::CellFrame& frame) {
  Task message;
  message.header.frame_id = kMapFrame;
  message.plan_id = order.plan_id;
  message.task_id = static_cast<std::uint32_t>(order.task_id);
  message.sequence = static_cast<std::uint32_t>(order.sequence);
  message.robot_tasks = static_cast<std::uint32_t>(order.robot_tasks);
  message.robot_id = robot;
  message.action = toMessage(sylph::actionBetween(order.start, order.end).value());
  message.start_cell = toMessage(order.start);
  message.end_cell = toMessage(order.end);
  message.start_pos = toMessage(frame.toPoint(order.start));
  message.end_pos = toMessage(frame.toPoint(order.end));
  message.time = static_cast<std::uint32_t>(order.timestep);
  message.dependencies.assign(order.dependencies.begin(), order.dependencies.end());
  message.status = static_cast<std::uint8_t>(order.status);
  return message;
}

std::optional<sylph::TaskOrder> fromMessage(const Task& message, const sylph::CellFrame& frame,
                                            std::string& reason) {
  const std::string fault = faultOf(message, frame);
  if (!fault.empty()) {
    reason = "task " + std::to_string(message.task_id) + " of plan " +
             std::to_string(message.plan_id) + ": " + fault;
    return std::nullopt;
  }
  sylph::TaskOrder order;
  order.plan_id = message.plan_id;
  order.sequence = static_cast<int>(message.sequence);
  order.start = fromMessage(message.start_cell);
  order.end = fromMessage(message.end_cell);
  order.status = static_cast<sylph::TaskStatus>(message.status);
  order.robot_tasks = static_cast<int>(message.robot_tasks);
  order.task_id = static_cast<sylph::TaskId>(message.task_id);
  order.timestep = static_cast<sylph::Timestep>(message.time);
  order.dependencies.assign(message.dependencies.begin(), message.dependencies.end());
  return order;
}

TaskReport toMessage(const sylph::RobotReport& report) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const sylph::Pose2d pose = report.pose.value_or(sylph::Pose2d{kNone, kNone, kNone});
  TaskReport message;
  message.report_id = report.report_id;
  message.plan_id = report.plan_id;
  message.accepted = static_cast<std::uint32_t>(report.accepted);
  message.done = static_cast<std::uint32_t>(report.done);
  message.state = static_cast<std::uint8_t>(report.state);
  message.detail = report.detail;
  message.x = pose.x_m;
  message.y = pose.y_m;
  message.yaw = pose.yaw_rad;
  message.tracking_error_m = report.tracking_error_m;
  message.heading_error_rad = report.heading_error_rad;
  message.pose_age_s = report.pose_age_s;
  return message;
}

std::optional<sylph::RobotReport> fromMessage(const TaskReport& message) {
  if (message.state > TaskReport::BLIND || message.accepted > kMaxCount ||
      message.done > message.accepted) {
    return std::nullopt;
  }
  sylph::RobotReport report;
  report.report_id = message.report_id;
  report.stamp_s = message.header.stamp.toSec();
  report.plan_id = message.plan_id;
  report.accepted = static_cast<int>(message.accepted);
  report.done = static_cast<int>(message.done);
  report.state = static_cast<sylph::RobotState>(message.state);
  report.detail = message.detail;
  const sylph::Pose2d pose{message.x, message.y, message.yaw};
  if (sylph::isFinite(pose)) {
    report.pose = pose;
  }
  report.tracking_error_m = message.tracking_error_m;
  report.heading_error_rad = message.heading_error_rad;
  report.pose_age_s = message.pose_age_s;
  return report;
}

}  // namespace sylph_ros
