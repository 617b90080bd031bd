#include "sylph_core/mission/robot_goals.hpp"

#include <algorithm>

#include "sylph_core/text/join.hpp"

namespace sylph {

Experiment withGoals(const Experiment& lab, const RobotGoals& goals, const Configuration& cells) {
  Experiment mission = lab;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    RobotSpec& robot = mission.robots[i];
    const auto goal = goals.find(robot.name);
    robot.start = cells.at(i);
    robot.goal = goal == goals.end() ? robot.start : goal->second;
  }
  return mission;
}

Experiment withParticipants(Experiment lab, const RobotGoals& goals, bool others_give_way) {
  if (!others_give_way) {
    lab.robots.erase(
        std::remove_if(lab.robots.begin(), lab.robots.end(),
                       [&](const RobotSpec& robot) { return goals.count(robot.name) == 0; }),
        lab.robots.end());
  }
  return lab;
}

std::string headlineOf(const RobotGoals& goals, std::size_t robots, bool others_give_way) {
  std::string text = join(goals, ", ", [](const auto& robot_and_goal) {
    const auto& [robot, goal] = robot_and_goal;
    return robot + " to " + toString(goal);
  });
  const std::size_t others = robots - goals.size();
  if (others > 0) {
    text += "; " + std::to_string(others) + (others == 1 ? " robot " : " robots ");
    text += others_give_way ? "may give way" : others == 1 ? "stays" : "stay";
  }
  return text;
}

}  // namespace sylph
