#include "sylph_adg_central/conversions.hpp"

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_adg_central {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

// Enumerators have the values of the messages' constants.
template <typename Enumerator>
constexpr bool isSame(Enumerator enumerator, std::uint8_t constant) {
  return static_cast<std::uint8_t>(enumerator) == constant;
}
static_assert(isSame(sylph::ExecutionPhase::Idle, AdgState::IDLE) &&
              isSame(sylph::ExecutionPhase::Pending, AdgState::PENDING) &&
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
template <typename Integer>
std::uint32_t toUnsigned(Integer value) {
  return static_cast<std::uint32_t>(value);
}

}  // namespace

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
  message.waited_s = view.waited_s;
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
