#include "sylph_adg_central/conversions.hpp"

#include <cmath>
#include <limits>

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_adg_central {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;
using sylph_msgs::TaskReport;

// Enumerators have the values of the messages' constants.
template <typename Enumerator>
constexpr bool isSame(Enumerator enumerator, std::uint8_t constant) {
  return static_cast<std::uint8_t>(enumerator) == constant;
}
static_assert(isSame(sylph::ExecutionPhase::Idle, AdgState::IDLE) &&
              isSame(sylph::ExecutionPhase::Receiving, AdgState::RECEIVING) &&
              isSame(sylph::ExecutionPhase::Executing, AdgState::EXECUTING) &&
              isSame(sylph::ExecutionPhase::Cutting, AdgState::CUTTING) &&
              isSame(sylph::ExecutionPhase::AtCut, AdgState::AT_CUT) &&
              isSame(sylph::ExecutionPhase::Finished, AdgState::FINISHED) &&
              isSame(sylph::ExecutionPhase::Refused, AdgState::REFUSED));
static_assert(isSame(sylph::ExecutionMode::Run, AdgState::RUN) &&
              isSame(sylph::ExecutionMode::Pause, AdgState::PAUSE) &&
              isSame(sylph::ExecutionMode::Stop, AdgState::STOP));
static_assert(isSame(sylph::RobotCondition::Ok, RobotExecution::OK) &&
              isSame(sylph::RobotCondition::Silent, RobotExecution::SILENT) &&
              isSame(sylph::RobotCondition::Stuck, RobotExecution::STUCK) &&
              isSame(sylph::RobotCondition::Blind, RobotExecution::BLIND) &&
              isSame(sylph::RobotCondition::Lost, RobotExecution::LOST));
static_assert(isSame(sylph::ReportState::Idle, TaskReport::IDLE) &&
              isSame(sylph::ReportState::Moving, TaskReport::MOVING) &&
              isSame(sylph::ReportState::Holding, TaskReport::HOLDING) &&
              isSame(sylph::ReportState::Blind, TaskReport::BLIND));
static_assert(isSame(sylph::TaskStatus::Staged, sylph_msgs::Task::STAGED) &&
              isSame(sylph::TaskStatus::Enqueued, sylph_msgs::Task::ENQUEUED) &&
              isSame(sylph::TaskStatus::Done, sylph_msgs::Task::DONE));

template <typename Integer>
std::uint32_t toUnsigned(Integer value) {
  return static_cast<std::uint32_t>(value);
}

}  // namespace

sylph_msgs::Task toMessage(const sylph::TaskOrder& order, const std::string& robot,
                           const sylph::CellFrame& frame) {
  sylph_msgs::Task message;
  message.header.frame_id = sylph_ros::kMapFrame;
  message.plan_id = order.plan_id;
  message.task_id = toUnsigned(order.task.id);
  message.sequence = toUnsigned(order.sequence);
  message.robot_tasks = toUnsigned(order.robot_tasks);
  message.robot_id = robot;
  message.action = sylph_ros::toMessage(order.task.action);
  message.start_cell = sylph_ros::toMessage(order.task.start);
  message.end_cell = sylph_ros::toMessage(order.task.end);
  message.start_pos = sylph_ros::toMessage(frame.toPoint(order.task.start));
  message.end_pos = sylph_ros::toMessage(frame.toPoint(order.task.end));
  message.time = toUnsigned(order.task.timestep);
  for (const sylph::TaskId dependency : order.dependencies) {
    message.dependencies.push_back(toUnsigned(dependency));
  }
  message.status = static_cast<std::uint8_t>(order.status);
  return message;
}

std::optional<sylph::RobotReport> fromMessage(const TaskReport& message) {
  constexpr auto kMaxCount = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
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
  report.state = static_cast<sylph::ReportState>(message.state);
  report.detail = message.detail;
  if (std::isfinite(message.x) && std::isfinite(message.y)) {
    report.position = sylph::Point{message.x, message.y};
  }
  report.tracking_error_m = message.tracking_error_m;
  report.pose_age_s = message.pose_age_s;
  return report;
}

RobotExecution toMessage(const sylph::RobotView& view, const std::string& robot) {
  RobotExecution message;
  message.robot_id = robot;
  message.condition = static_cast<std::uint8_t>(view.condition);
  message.report_state = static_cast<std::uint8_t>(view.report_state);
  message.tasks_total = toUnsigned(view.tasks_total);
  message.tasks_done = toUnsigned(view.tasks_done);
  message.step = toUnsigned(view.step);
  message.cell = sylph_ros::toMessage(view.cell);
  message.next_cell = message.cell;
  if (view.task) {
    message.task_id = toUnsigned(view.task->id);
    message.task_status = static_cast<std::uint8_t>(view.task_status);
    message.action = sylph_ros::toMessage(view.task->action);
    message.next_cell = sylph_ros::toMessage(view.task->end);
  }
  message.goal = sylph_ros::toMessage(view.goal);
  message.held_cells = sylph_ros::toMessage(view.held_cells);
  message.remaining_path = sylph_ros::toMessage(view.remaining_path);
  message.partner = view.partner;
  message.svo_deg = view.svo_deg;
  message.waiting = !view.waits_for_robot.empty();
  message.waits_for_robot = view.waits_for_robot;
  message.waits_for_task = toUnsigned(view.waits_for_task);
  message.waits_for_cell = sylph_ros::toMessage(view.waits_for_cell);
  message.waiting_since_s = view.waiting_since_s;
  message.root_cause_robot = view.root_cause_robot;
  message.root_cause = view.root_cause;
  return message;
}

AdgState toMessage(const sylph::Execution& execution, double now_s) {
  AdgState message;
  message.header.frame_id = sylph_ros::kMapFrame;
  message.plan_id = execution.planId();
  message.last_plan_id = execution.lastPlanId();
  message.phase = static_cast<std::uint8_t>(execution.phase());
  message.mode = static_cast<std::uint8_t>(execution.mode());
  message.message = execution.message();
  for (int robot = 0; robot < execution.robotCount(); ++robot) {
    message.robots.push_back(toMessage(execution.view(robot, now_s), execution.name(robot)));
  }
  return message;
}

}  // namespace sylph_adg_central
