#pragma once

#include <array>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Obstacles and who stands where, with a border of obstacles so wide that looking round an agent
/// never leaves the map. Cells have indices; a move north, east, south or west adds a step to one.
class OccupancyMap {
 public:
  /// @param margin  width of the border [cells], > 0
  OccupancyMap(const Grid& grid, int margin);

  /// Of a cell of the grid or its border.
  int indexOf(const Cell& cell) const {
    return (cell.row + margin_) * stride_ + cell.col + margin_;
  }
  /// The cell of an index; in the border it lies outside the grid.
  Cell cellAt(int index) const { return {index / stride_ - margin_, index % stride_ - margin_}; }
  /// What the moves North, East, South, West, in this order, add to an index.
  const std::array<int, 4>& steps() const { return steps_; }
  /// Number of indices.
  int size() const { return static_cast<int>(is_obstacle_.size()); }

  /// True in the border, too.
  bool isObstacle(int index) const { return is_obstacle_[static_cast<std::size_t>(index)] != 0; }
  /// The agent on a cell, -1 if there is none.
  AgentId occupant(int index) const { return occupants_[static_cast<std::size_t>(index)]; }

  /// Takes all agents off the map and puts these there.
  void place(const Configuration& cells);

 private:
  int margin_;
  int stride_;
  std::array<int, 4> steps_;
  std::vector<char> is_obstacle_;
  std::vector<AgentId> occupants_;
  std::vector<int> occupied_;  // indices with an agent
};

}  // namespace sylph
