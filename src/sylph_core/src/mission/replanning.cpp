#include "sylph_core/mission/replanning.hpp"

#include <algorithm>
#include <set>

#include "sylph_core/grid/components.hpp"
#include "sylph_core/grid/distance_field.hpp"

namespace sylph {
namespace {

[[noreturn]] void fail(const std::string& message) {
  throw MissionFailure(MissionOutcome::PlanRefused, "cannot plan the rest: " + message);
}

const RobotExecution& executionOf(const std::string& robot, const AdgState& cut) {
  const auto found = std::find_if(cut.robots.begin(), cut.robots.end(),
                                  [&](const RobotExecution& r) { return r.robot == robot; });
  if (found == cut.robots.end()) {
    fail("the central node does not know " + robot);
  }
  return *found;
}

/// The free cell of `label` nearest to `goal` by the way on the map without lost robots.
Cell nearestCell(const Grid& map, const Grid& grid, const std::vector<int>& labels, int label,
                 const Cell& goal, const std::set<Cell>& taken) {
  // By the map as it was: the way around a lost robot may not exist, and the nearest by air may be
  // behind a wall.
  const DistanceField distance(map, goal);
  Cell best;
  int best_distance = DistanceField::kUnreachable;
  for (const Cell& cell : grid.freeCells()) {
    const bool is_candidate =
        labels[static_cast<std::size_t>(grid.indexOf(cell))] == label && taken.count(cell) == 0;
    if (is_candidate && distance.at(cell) < best_distance) {
      best = cell;
      best_distance = distance.at(cell);
    }
  }
  // As many cells as robots are in each part of the map, so that one is left for everybody.
  return best;
}

/// Replaces the goals that cannot be reached any more.
void adaptGoals(const Grid& map, RestOfMission& rest) {
  Instance& instance = rest.instance;
  const std::vector<int> labels = connectedComponents(instance.grid).label;
  const auto labelOf = [&](const Cell& cell) {
    return labels[static_cast<std::size_t>(instance.grid.indexOf(cell))];
  };
  std::set<Cell> taken;
  std::vector<std::size_t> without_goal;
  for (std::size_t i = 0; i < rest.robots.size(); ++i) {
    if (instance.grid.isFree(instance.goals[i]) &&
        labelOf(instance.goals[i]) == labelOf(instance.starts[i])) {
      taken.insert(instance.goals[i]);
    } else {
      without_goal.push_back(i);
    }
  }
  for (const std::size_t i : without_goal) {
    const Cell wanted = instance.goals[i];
    instance.goals[i] =
        nearestCell(map, instance.grid, labels, labelOf(instance.starts[i]), wanted, taken);
    taken.insert(instance.goals[i]);
    rest.given_up.push_back(rest.robots[i] + " cannot reach " + toString(wanted) +
                            " any more and goes to " + toString(instance.goals[i]));
  }
}

}  // namespace

RestOfMission restOfMission(const Mission& mission, const AdgState& cut) {
  RestOfMission rest;
  Instance& instance = rest.instance;
  instance.grid = mission.grid;
  instance.motion.rotations = false;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    const RobotExecution& robot = executionOf(mission.robots[i], cut);
    if (robot.condition == RobotCondition::Lost) {
      // Where exactly it stands nobody knows; it may be in any of the cells that were given to it.
      for (const Cell& cell : robot.held_cells) {
        if (instance.grid.isInside(cell)) {
          instance.grid.setObstacle(cell);
        }
      }
      continue;
    }
    rest.robots.push_back(mission.robots[i]);
    instance.starts.push_back(robot.cell);
    instance.goals.push_back(mission.goals[i]);
  }
  if (rest.robots.empty()) {
    fail("all robots are lost");
  }
  for (std::size_t i = 0; i < rest.robots.size(); ++i) {
    if (!instance.grid.isFree(instance.starts[i])) {
      fail(rest.robots[i] + " is reported in cell " + toString(instance.starts[i]) +
           ", which is not free");
    }
  }
  adaptGoals(mission.grid, rest);
  return rest;
}

}  // namespace sylph
