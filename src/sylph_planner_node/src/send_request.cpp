#include "sylph_planner_node/send_request.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "sylph_core/mission/goal_judge.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph_planner_node {
namespace {

/// "ROW,COL"; nothing if it is anything else, be it more.
std::optional<sylph::Cell> readCell(const std::string& text) {
  sylph::Cell cell;
  const char* const end = text.data() + text.size();
  const auto row = std::from_chars(text.data(), end, cell.row);
  if (row.ec != std::errc() || row.ptr == end || *row.ptr != ',') {
    return std::nullopt;
  }
  const auto col = std::from_chars(row.ptr + 1, end, cell.col);
  return col.ec == std::errc() && col.ptr == end ? std::make_optional(cell) : std::nullopt;
}

std::pair<std::string, sylph::Cell> readGoal(const std::string& argument) {
  const std::size_t sign = argument.find(":=");
  if (sign != std::string::npos && sign > 0) {
    if (const auto cell = readCell(argument.substr(sign + 2))) {
      return {argument.substr(0, sign), *cell};
    }
  }
  throw std::invalid_argument("'" + argument +
                              "': a goal must be ROBOT:=ROW,COL, such as robot_3:=4,7");
}

}  // namespace

RobotGoals readGoals(const std::vector<std::string>& arguments, const sylph::Experiment& lab) {
  const std::vector<std::string> names = namesOf(lab);
  const sylph::GoalJudge judge(lab.grid);
  RobotGoals goals;
  sylph::CellOwners taken;
  for (const std::string& argument : arguments) {
    const auto [robot, cell] = readGoal(argument);
    if (std::find(names.begin(), names.end(), robot) == names.end()) {
      throw std::invalid_argument(sylph::unknownRobot(robot, names));
    }
    if (!goals.emplace(robot, cell).second) {
      throw std::invalid_argument("robot " + robot + " is named twice");
    }
    const std::string refusal = judge.refusal(robot, cell, std::nullopt, taken);
    if (!refusal.empty()) {
      throw std::invalid_argument(refusal);
    }
    taken.emplace(cell, robot);
  }
  return goals;
}

sylph::Experiment toExperiment(const SendRequest& request, const sylph::Experiment& lab,
                               const sylph::Configuration& cells) {
  sylph::Experiment mission = lab;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    sylph::RobotSpec& robot = mission.robots[i];
    const auto goal = request.goals.find(robot.name);
    robot.start = cells.at(i);
    robot.goal = goal == request.goals.end() ? robot.start : goal->second;
  }
  mission.planning.planner = request.planner.value_or(lab.planning.planner);
  mission.planning.time_limit_s = request.time_limit_s.value_or(lab.planning.time_limit_s);
  mission.seed = request.seed.value_or(lab.seed);
  return mission;
}

sylph::Experiment withParticipants(const SendRequest& request, sylph::Experiment mission) {
  if (!request.others_give_way) {
    mission.robots.erase(std::remove_if(mission.robots.begin(), mission.robots.end(),
                                        [&](const sylph::RobotSpec& robot) {
                                          return request.goals.count(robot.name) == 0;
                                        }),
                         mission.robots.end());
  }
  return mission;
}

std::string headlineOf(const SendRequest& request, const sylph::Experiment& lab) {
  std::string text = sylph::join(request.goals, ", ", [](const auto& robot_and_goal) {
    const auto& [robot, goal] = robot_and_goal;
    return robot + " to " + toString(goal);
  });
  const std::size_t others = lab.robots.size() - request.goals.size();
  if (others > 0) {
    text += "; " + std::to_string(others) + (others == 1 ? " robot " : " robots ");
    text += request.others_give_way ? "may give way" : others == 1 ? "stays" : "stay";
  }
  return text;
}

}  // namespace sylph_planner_node
