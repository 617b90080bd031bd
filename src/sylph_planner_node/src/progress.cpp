#include "sylph_planner_node/progress.hpp"

#include <sylph_msgs/TaskReport.h>

#include <algorithm>
#include <cstdio>

#include "sylph_ros/conversions.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::ExecuteMissionResult;
using sylph_msgs::RobotExecution;

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f s", value);
  return text;
}

std::string conditionText(const RobotExecution& robot) {
  switch (robot.condition) {
    case RobotExecution::SILENT:
      return "is silent";
    case RobotExecution::STUCK:
      return "is stuck";
    case RobotExecution::BLIND:
      return "has no good pose";
    case RobotExecution::LOST:
      return "is lost";
    default:
      return "";
  }
}

std::string waitingText(const RobotExecution& robot) {
  std::string text = robot.robot_id + " waits " + seconds(robot.waited_s) + " for " +
                     robot.waits_for_robot + " to leave " +
                     sylph::toString(sylph_ros::fromMessage(robot.waits_for_cell));
  if (!robot.root_cause_robot.empty() && robot.root_cause_robot != robot.waits_for_robot) {
    text += "; held up by " + robot.root_cause_robot;
  }
  if (!robot.root_cause.empty()) {
    text += ": " + robot.root_cause;
  }
  return text;
}

bool isOnGoal(const Mission& mission, const RobotExecution& robot) {
  const std::size_t index = mission.indexOf(robot.robot_id);
  return index < mission.robots.size() && robot.condition != RobotExecution::LOST &&
         robot.tasks_done >= robot.tasks_total &&
         sylph_ros::fromMessage(robot.cell) == mission.goals[index];
}

}  // namespace

std::vector<std::string> waitingLines(const AdgState& state) {
  std::vector<std::string> lines;
  if (state.mode != AdgState::RUN) {
    lines.push_back(std::string(state.mode == AdgState::PAUSE ? "paused" : "stopped") +
                    (state.message.empty() ? "" : ": " + state.message) +
                    "; /sylph/resume goes on");
  }
  for (const RobotExecution& robot : state.robots) {
    if (robot.condition != RobotExecution::OK) {
      lines.push_back(robot.robot_id + " " + conditionText(robot) +
                      (robot.root_cause.empty() ? "" : ": " + robot.root_cause));
    } else if (robot.waiting) {
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

sylph_msgs::ExecuteMissionFeedback toFeedback(const std::string& phase, const Mission& mission,
                                              const AdgState& state) {
  sylph_msgs::ExecuteMissionFeedback feedback;
  feedback.phase = phase;
  for (const RobotExecution& robot : state.robots) {
    feedback.tasks_done += robot.tasks_done;
    feedback.tasks_total += robot.tasks_total;
  }
  feedback.robots_arrived = robotsArrived(mission, state);
  feedback.waiting = waitingLines(state);
  return feedback;
}

ExecuteMissionResult finishedResult(const Mission& mission, const AdgState& state,
                                    const std::vector<std::string>& given_up) {
  ExecuteMissionResult result;
  result.robots = static_cast<std::uint32_t>(mission.robots.size());
  result.arrived = robotsArrived(mission, state);
  result.execution_s = state.elapsed_s;
  if (result.arrived == result.robots) {
    result.outcome = ExecuteMissionResult::SUCCESS;
    result.message = "all " + std::to_string(result.robots) + " robots have arrived";
    return result;
  }
  result.outcome = ExecuteMissionResult::INCOMPLETE;
  result.message = std::to_string(result.arrived) + " of " + std::to_string(result.robots) +
                   " robots have arrived";
  for (const RobotExecution& robot : state.robots) {
    if (robot.condition == RobotExecution::LOST) {
      result.message += "; " + robot.robot_id + " is lost";
    }
  }
  for (const std::string& line : given_up) {
    result.message += "; " + line;
  }
  return result;
}

bool isExecutionOf(const Mission& mission, const AdgState& state) {
  const bool is_under_way = state.phase == AdgState::EXECUTING ||
                            state.phase == AdgState::CUTTING || state.phase == AdgState::AT_CUT;
  std::size_t members = 0;
  for (const RobotExecution& robot : state.robots) {
    const std::size_t index = mission.indexOf(robot.robot_id);
    if (index < mission.robots.size()) {
      ++members;
      if (robot.condition != RobotExecution::LOST &&
          sylph_ros::fromMessage(robot.goal) != mission.goals[index]) {
        return false;
      }
    }
  }
  return is_under_way && members == mission.robots.size();
}

bool isBusy(const AdgState& state) {
  return state.phase == AdgState::EXECUTING || state.phase == AdgState::CUTTING ||
         state.phase == AdgState::AT_CUT;
}

bool allHold(const AdgState& state) {
  return state.mode != AdgState::RUN &&
         std::none_of(state.robots.begin(), state.robots.end(), [](const RobotExecution& robot) {
           return robot.report_state == sylph_msgs::TaskReport::MOVING;
         });
}

}  // namespace sylph_planner_node
