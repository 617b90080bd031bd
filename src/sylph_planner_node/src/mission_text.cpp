#include "sylph_planner_node/mission_text.hpp"

#include <iomanip>
#include <sstream>

#include "sylph_ros/conversions.hpp"

namespace sylph_planner_node {

using sylph_msgs::ExecuteMissionResult;

sylph_msgs::ExecuteMissionGoal toGoal(const sylph::Experiment& experiment) {
  sylph_msgs::ExecuteMissionGoal goal;
  goal.map = experiment.map_path;
  goal.cell_size_m = experiment.cell_size_m;
  for (const sylph::RobotSpec& robot : experiment.robots) {
    goal.robots.push_back(robot.name);
    goal.goals.push_back(sylph_ros::toMessage(robot.goal));
  }
  goal.planner = experiment.planning.planner;
  goal.time_limit_s = experiment.planning.time_limit_s;
  goal.seed = experiment.seed;
  return goal;
}

std::string progressText(const sylph_msgs::ExecuteMissionFeedback& feedback, std::size_t robots) {
  std::ostringstream text;
  text << feedback.phase;
  if (feedback.tasks_total > 0) {
    text << ": " << feedback.tasks_done << " of " << feedback.tasks_total << " tasks, "
         << feedback.robots_arrived << " of " << robots << " robots arrived";
  }
  for (const std::string& line : feedback.waiting) {
    text << "\n    " << line;
  }
  return text.str();
}

std::string resultText(const ExecuteMissionResult& result) {
  std::ostringstream text;
  text << outcomeName(result.outcome) << ": " << result.message << "\n"
       << "  robots " << result.robots << ", arrived " << result.arrived << ", steps "
       << result.plan_steps << ", sum of costs " << result.sum_of_costs << ", replans "
       << result.replans << "\n"
       << std::fixed << std::setprecision(2) << "  planned in " << result.planning_s
       << " s, carried out in " << result.execution_s << " s";
  return text.str();
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

std::string joinNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace sylph_planner_node
