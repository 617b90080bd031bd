#include "sylph_planner_node/send_request.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "sylph_core/mission/goal_judge.hpp"

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

sylph::RobotGoals readGoals(const std::vector<std::string>& arguments,
                            const sylph::Experiment& lab) {
  const std::vector<std::string> names = namesOf(lab);
  const sylph::GoalJudge judge(lab.grid);
  sylph::RobotGoals goals;
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
  sylph::Experiment mission = withGoals(lab, request.goals, cells);
  mission.planning.planner = request.planner.value_or(lab.planning.planner);
  mission.planning.time_limit_s = request.time_limit_s.value_or(lab.planning.time_limit_s);
  mission.seed = request.seed.value_or(lab.seed);
  return mission;
}

}  // namespace sylph_planner_node
