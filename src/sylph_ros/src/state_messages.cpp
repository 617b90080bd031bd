#include "sylph_ros/state_messages.hpp"

#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <limits>

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/same_constants.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

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

std::vector<sylph::Cell> toCells(const std::vector<sylph_msgs::Cell>& messages) {
  std::vector<sylph::Cell> cells;
  cells.reserve(messages.size());
  for (const sylph_msgs::Cell& message : messages) {
    cells.push_back(fromMessage(message));
  }
  return cells;
}

RobotExecution toRobotMessage(const sylph::RobotExecution& robot) {
  RobotExecution message;
  message.robot_id = robot.robot;
  message.condition = static_cast<std::uint8_t>(robot.condition);
  message.report_state = static_cast<std::uint8_t>(robot.report_state);
  message.tasks_total = static_cast<std::uint32_t>(robot.tasks_total);
  message.tasks_done = static_cast<std::uint32_t>(robot.tasks_done);
  message.step = static_cast<std::uint32_t>(robot.step);
  message.task_id = static_cast<std::uint32_t>(robot.task_id);
  message.task_status = static_cast<std::uint8_t>(robot.task_status);
  message.action = toMessage(robot.action);
  message.cell = toMessage(robot.cell);
  message.next_cell = toMessage(robot.next_cell);
  message.goal = toMessage(robot.goal);
  message.held_cells = toMessage(robot.held_cells);
  message.remaining_path = toMessage(robot.remaining_path);
  message.partner = robot.partner;
  message.svo_deg = robot.svo_deg;
  message.waiting = static_cast<std::uint8_t>(!robot.waits_for_robot.empty());
  message.waits_for_robot = robot.waits_for_robot;
  message.waits_for_task = static_cast<std::uint32_t>(robot.waits_for_task);
  message.waits_for_cell = toMessage(robot.waits_for_cell);
  message.waited_s = robot.waited_s;
  message.aligning = static_cast<std::uint8_t>(robot.is_aligning);
  message.root_cause_robot = robot.root_cause_robot;
  message.root_cause = robot.root_cause;
  return message;
}

bool isSane(const RobotExecution& message) {
  // Anybody may publish on the topic: a number that is no enumerator would be undefined behaviour
  // further on.
  constexpr auto kMaxCount = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
  return message.condition <= RobotExecution::LOST &&
         message.report_state <= sylph_msgs::TaskReport::BLIND &&
         message.task_status <= sylph_msgs::Task::DONE && actionFromMessage(message.action) &&
         message.tasks_total <= kMaxCount && message.tasks_done <= message.tasks_total &&
         message.step <= kMaxCount;
}

sylph::RobotExecution fromRobotMessage(const RobotExecution& message) {
  sylph::RobotExecution robot;
  robot.robot = message.robot_id;
  robot.condition = static_cast<sylph::RobotCondition>(message.condition);
  robot.report_state = static_cast<sylph::RobotState>(message.report_state);
  robot.tasks_total = static_cast<int>(message.tasks_total);
  robot.tasks_done = static_cast<int>(message.tasks_done);
  robot.step = static_cast<sylph::Timestep>(message.step);
  robot.task_id = static_cast<sylph::TaskId>(message.task_id);
  robot.task_status = static_cast<sylph::TaskStatus>(message.task_status);
  robot.action = *actionFromMessage(message.action);
  robot.cell = fromMessage(message.cell);
  robot.next_cell = fromMessage(message.next_cell);
  robot.goal = fromMessage(message.goal);
  robot.held_cells = toCells(message.held_cells);
  robot.remaining_path = toCells(message.remaining_path);
  robot.partner = message.partner;
  robot.svo_deg = message.svo_deg;
  robot.waits_for_robot = message.waiting != 0 ? message.waits_for_robot : std::string();
  robot.waits_for_task = static_cast<sylph::TaskId>(message.waits_for_task);
  robot.waits_for_cell = fromMessage(message.waits_for_cell);
  robot.waited_s = message.waited_s;
  robot.is_aligning = message.aligning != 0;
  robot.root_cause_robot = message.root_cause_robot;
  robot.root_cause = message.root_cause;
  return robot;
}

}  // namespace

AdgState toMessage(const sylph::AdgState& state) {
  AdgState message;
  message.header.frame_id = kMapFrame;
  message.plan_id = state.plan_id;
  message.last_plan_id = state.last_plan_id;
  message.executed_plan_id = state.executed_plan_id;
  message.phase = static_cast<std::uint8_t>(state.phase);
  message.mode = static_cast<std::uint8_t>(state.mode);
  message.message = state.message;
  message.steps = state.steps;
  message.elapsed_s = state.elapsed_s;
  for (const sylph::RobotExecution& robot : state.robots) {
    message.robots.push_back(toRobotMessage(robot));
  }
  return message;
}

std::optional<sylph::AdgState> fromMessage(const AdgState& message) {
  const std::optional<sylph::ExecutionMode> mode = modeFromMessage(message);
  if (!mode || message.phase > AdgState::REFUSED) {
    return std::nullopt;
  }
  sylph::AdgState state;
  state.plan_id = message.plan_id;
  state.last_plan_id = message.last_plan_id;
  state.executed_plan_id = message.executed_plan_id;
  state.phase = static_cast<sylph::ExecutionPhase>(message.phase);
  state.mode = *mode;
  state.message = message.message;
  state.steps = message.steps;
  state.elapsed_s = message.elapsed_s;
  for (const RobotExecution& robot : message.robots) {
    if (!isSane(robot)) {
      return std::nullopt;
    }
    state.robots.push_back(fromRobotMessage(robot));
  }
  return state;
}

std::optional<sylph::ExecutionMode> modeFromMessage(const AdgState& message) {
  if (message.mode > AdgState::STOP) {
    return std::nullopt;
  }
  return static_cast<sylph::ExecutionMode>(message.mode);
}

}  // namespace sylph_ros
