#include "sylph_core/mission/goal_judge.hpp"

#include <set>
#include <utility>

#include "sylph_core/files/nearest_names.hpp"
#include "sylph_core/grid/components.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

Grid withObstacles(Grid grid, const CellOwners& bystanders) {
  for (const auto& [cell, robot] : bystanders) {
    grid.setObstacle(cell);
  }
  return grid;
}

}  // namespace

GoalJudge::GoalJudge(const Grid& map, CellOwners bystanders)
    : map_(map),
      grid_(withObstacles(map, bystanders)),
      bystanders_(std::move(bystanders)),
      map_labels_(connectedComponents(map_).label),
      labels_(connectedComponents(grid_).label) {}

std::string GoalJudge::refusal(const std::string& robot, const Cell& goal,
                               const std::optional<Cell>& start, const CellOwners& taken) const {
  const std::string subject = "goal " + toString(goal) + " of " + robot;
  if (!map_.isInside(goal)) {
    return subject + " lies outside the map of " + std::to_string(map_.rows()) + " x " +
           std::to_string(map_.cols()) + " cells";
  }
  if (!map_.isFree(goal)) {
    return subject + " lies on an obstacle";
  }
  const auto owner = taken.find(goal);
  if (owner != taken.end() && owner->second != robot) {
    return subject + " is also the goal of " + owner->second;
  }
  const auto bystander = bystanders_.find(goal);
  if (bystander != bystanders_.end()) {
    return subject + " is where " + bystander->second + " stands, which has no part in the mission";
  }
  const std::string reason = start ? unreachable(goal, *start) : "";
  return reason.empty() ? reason : subject + " " + reason;
}

std::string GoalJudge::unreachable(const Cell& goal, const Cell& start) const {
  const int label = labelOf(labels_, start);
  if (labelOf(labels_, goal) == label) {
    return {};
  }
  std::string text = "cannot be reached from its cell " + toString(start);
  if (labelOf(map_labels_, goal) != labelOf(map_labels_, start)) {
    return text;
  }
  std::set<std::string> in_the_way;
  for (const auto& [cell, robot] : bystanders_) {
    for (const Cell& next : {Cell{cell.row - 1, cell.col}, Cell{cell.row + 1, cell.col},
                             Cell{cell.row, cell.col - 1}, Cell{cell.row, cell.col + 1}}) {
      if (grid_.isFree(next) && labelOf(labels_, next) == label) {
        in_the_way.insert(robot);
      }
    }
  }
  return text + " past robots without part in the mission: " + join(in_the_way);
}

int GoalJudge::labelOf(const std::vector<int>& labels, const Cell& cell) const {
  return labels[static_cast<std::size_t>(grid_.indexOf(cell))];
}

void requireGoals(const Mission& mission) {
  const GoalJudge judge(mission.grid);
  CellOwners taken;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    const std::string refusal =
        judge.refusal(mission.robots[i], mission.goals[i], std::nullopt, taken);
    if (!refusal.empty()) {
      throw MissionFailure(MissionOutcome::BadRequest, refusal);
    }
    taken.emplace(mission.goals[i], mission.robots[i]);
  }
}

std::string unknownRobot(const std::string& name, const std::vector<std::string>& lab) {
  return "unknown robot '" + name + "'; the nearest names are " + join(nearestNames(name, lab));
}

}  // namespace sylph
