#include "sylph_planner_node/mission_text.hpp"

#include <iomanip>
#include <sstream>

#include "sylph_ros/missions.hpp"

namespace sylph_planner_node {

using sylph_msgs::ExecuteMissionResult;

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
  text << sylph_ros::outcomeName(result.outcome) << ": " << result.message << "\n"
       << "  robots " << result.robots << ", arrived " << result.arrived << ", steps "
       << result.plan_steps << ", sum of costs " << result.sum_of_costs << ", replans "
       << result.replans << "\n"
       << std::fixed << std::setprecision(2) << "  planned in " << result.planning_s
       << " s, carried out in " << result.execution_s << " s";
  return text.str();
}

std::string waysText(const sylph::MissionPlan& plan) {
  std::ostringstream text;
  for (std::size_t robot = 0; robot < plan.robots.size(); ++robot) {
    std::size_t moves = 0;
    std::size_t arrival = 0;
    for (std::size_t step = 1; step < plan.plan.size(); ++step) {
      if (plan.plan[step][robot] != plan.plan[step - 1][robot]) {
        ++moves;
        arrival = step;
      }
    }
    text << "  " << plan.robots[robot] << " " << plan.plan.front()[robot] << " to "
         << plan.goals[robot] << ": " << moves << (moves == 1 ? " move" : " moves")
         << ", arrives at step " << arrival << "\n";
  }
  return text.str();
}

}  // namespace sylph_planner_node
