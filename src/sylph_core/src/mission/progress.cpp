#include "sylph_core/mission/progress.hpp"

#include <algorithm>

#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

std::string conditionText(const RobotExecution& robot) {
  switch (robot.condition) {
    case RobotCondition::Silent:
      return "is silent";
    case RobotCondition::Stuck:
      return "is stuck";
    case RobotCondition::Blind:
      return "has no good pose";
    case RobotCondition::Lost:
      return "is lost";
    default:
      return "";
  }
}

std::string waitingText(const RobotExecution& robot) {
  std::string text = robot.robot + " waits " + format("%.1f s", robot.waited_s) + " for " +
                     robot.waits_for_robot + " to leave " + toString(robot.waits_for_cell);
  if (!robot.root_cause_robot.empty() && robot.root_cause_robot != robot.waits_for_robot) {
    text += "; held up by " + robot.root_cause_robot;
  }
  if (!robot.root_cause.empty()) {
    text += ": " + robot.root_cause;
  }
  return text;
}

bool isOnGoal(const Mission& mission, const RobotExecution& robot) {
  const std::size_t index = mission.indexOf(robot.robot);
  return index < mission.robots.size() && robot.condition != RobotCondition::Lost &&
         robot.tasks_done >= robot.tasks_total && robot.cell == mission.goals[index];
}

}  // namespace

std::vector<std::string> waitingLines(const AdgState& state) {
  std::vector<std::string> lines;
  if (state.mode != ExecutionMode::Run) {
    lines.push_back(std::string(state.mode == ExecutionMode::Pause ? "paused" : "stopped") +
                    (state.message.empty() ? "" : ": " + state.message) + "; sylph_resume goes on");
  } else if (!state.message.empty() && state.phase != ExecutionPhase::Refused) {
    lines.push_back(state.message);
  }
  for (const RobotExecution& robot : state.robots) {
    if (robot.condition != RobotCondition::Ok) {
      // The cause says more exactly what the condition does.
      lines.push_back(robot.robot + (robot.root_cause.empty() ? " " + conditionText(robot)
                                                              : ": " + robot.root_cause));
    } else if (!robot.waits_for_robot.empty()) {
      lines.push_back(waitingText(robot));
    }
  }
  return lines;
}

std::uint32_t robotsArrived(const Mission& mission, const AdgState& state) {
  return static_cast<std::uint32_t>(
      std::count_if(state.robots.begin(), state.robots.end(),
                    [&](const RobotExecution& robot) { return isOnGoal(mission, robot); }));
}

MissionProgress progressOf(const std::string& phase, const Mission& mission,
                           const AdgState& state) {
  MissionProgress progress;
  progress.phase = phase;
  for (const RobotExecution& robot : state.robots) {
    progress.tasks_done += static_cast<std::uint32_t>(robot.tasks_done);
    progress.tasks_total += static_cast<std::uint32_t>(robot.tasks_total);
  }
  progress.robots_arrived = robotsArrived(mission, state);
  progress.waiting = waitingLines(state);
  return progress;
}

MissionResult finishedResult(const Mission& mission, const AdgState& state,
                             const std::vector<std::string>& given_up) {
  MissionResult result;
  result.robots = static_cast<std::uint32_t>(mission.robots.size());
  result.arrived = robotsArrived(mission, state);
  result.execution_s = state.elapsed_s;
  if (result.arrived == result.robots) {
    result.outcome = MissionOutcome::Success;
    result.message = "all " + std::to_string(result.robots) + " robots have arrived";
    return result;
  }
  result.outcome = MissionOutcome::Incomplete;
  result.message = std::to_string(result.arrived) + " of " + std::to_string(result.robots) +
                   " robots have arrived";
  for (const RobotExecution& robot : state.robots) {
    if (robot.condition == RobotCondition::Lost) {
      result.message += "; " + robot.robot + " is lost";
    }
  }
  for (const std::string& line : given_up) {
    result.message += "; " + line;
  }
  return result;
}

bool isExecutionOf(const Mission& mission, const AdgState& state) {
  std::size_t members = 0;
  for (const RobotExecution& robot : state.robots) {
    const std::size_t index = mission.indexOf(robot.robot);
    if (index < mission.robots.size()) {
      ++members;
      if (robot.condition != RobotCondition::Lost && robot.goal != mission.goals[index]) {
        return false;
      }
    }
  }
  // The central node has to know all of them.
  return isBusy(state) && members == mission.robots.size();
}

bool isBusy(const AdgState& state) {
  return state.phase == ExecutionPhase::Executing || state.phase == ExecutionPhase::Cutting ||
         state.phase == ExecutionPhase::AtCut;
}

bool allHold(const AdgState& state) {
  return state.mode != ExecutionMode::Run &&
         std::none_of(state.robots.begin(), state.robots.end(), [](const RobotExecution& robot) {
           return robot.report_state == RobotState::Moving;
         });
}

}  // namespace sylph
