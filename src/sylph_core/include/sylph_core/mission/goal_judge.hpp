#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mission/mission.hpp"

namespace sylph {

/// Who stands on a cell or wants it: the name of a robot.
using CellOwners = std::map<Cell, std::string>;

/// Says whether a robot can be sent to a cell, and why not. The one judge of goals, of those of a
/// request as well as of those that an operator is about to set.
class GoalJudge {
 public:
  /// @param bystanders  cells on the map that robots without part in the mission touch
  explicit GoalJudge(const Grid& map, CellOwners bystanders = {});

  /// Why `robot` cannot be sent to `goal`, in one line; empty: it can.
  /// @param start  where it stands, a cell inside the map; nothing: not known, any goal is in reach
  /// @param taken  goals of robots; the robot's own is no reason
  std::string refusal(const std::string& robot, const Cell& goal, const std::optional<Cell>& start,
                      const CellOwners& taken = {}) const;

  /// The map; bystanders are obstacles in it.
  const Grid& grid() const { return grid_; }

 private:
  std::string unreachable(const Cell& goal, const Cell& start) const;
  int labelOf(const std::vector<int>& labels, const Cell& cell) const;

  Grid map_;
  Grid grid_;
  CellOwners bystanders_;
  std::vector<int> map_labels_;  ///< connected components without bystanders
  std::vector<int> labels_;      ///< and with them
};

/// What can be said of a mission's goals without knowing where its robots are.
/// @throws MissionFailure (BadRequest) with the first refusal
void requireGoals(const Mission& mission);

/// One line for a name that no robot has, with the names that may have been meant.
/// @param lab  the names that there are
std::string unknownRobot(const std::string& name, const std::vector<std::string>& lab);

}  // namespace sylph
