#include "sylph_ros/missions.hpp"

#include <actionlib_msgs/GoalStatus.h>
#include <sylph_msgs/ExecuteMissionResult.h>

#include <algorithm>

#include "sylph_ros/conversions.hpp"

namespace sylph_ros {

using sylph_msgs::ExecuteMissionResult;

sylph_msgs::ExecuteMissionGoal toGoal(const sylph::Experiment& experiment) {
  sylph_msgs::ExecuteMissionGoal goal;
  goal.map = experiment.map_path;
  goal.cell_size_m = experiment.cell_size_m;
  for (const sylph::RobotSpec& robot : experiment.robots) {
    goal.robots.push_back(robot.name);
    goal.goals.push_back(toMessage(robot.goal));
  }
  goal.planner = experiment.planning.planner;
  goal.time_limit_s = experiment.planning.time_limit_s;
  goal.seed = experiment.seed;
  return goal;
}

bool isUnderWay(const actionlib_msgs::GoalStatusArray& status) {
  using actionlib_msgs::GoalStatus;
  return std::any_of(
      status.status_list.begin(), status.status_list.end(), [](const GoalStatus& goal) {
        return goal.status == GoalStatus::PENDING || goal.status == GoalStatus::ACTIVE ||
               goal.status == GoalStatus::PREEMPTING;
      });
}

std::string outcomeName(std::uint8_t outcome) {
  switch (outcome) {
    case ExecuteMissionResult::SUCCESS:
      return "SUCCESS";
    case ExecuteMissionResult::BAD_REQUEST:
      return "BAD_REQUEST";
    case ExecuteMissionResult::NO_POSE:
      return "NO_POSE";
    case ExecuteMissionResult::NO_PLAN:
      return "NO_PLAN";
    case ExecuteMissionResult::PLAN_REFUSED:
      return "PLAN_REFUSED";
    case ExecuteMissionResult::PREEMPTED:
      return "PREEMPTED";
    case ExecuteMissionResult::INCOMPLETE:
      return "INCOMPLETE";
    default:
      return "outcome " + std::to_string(outcome);
  }
}

}  // namespace sylph_ros
