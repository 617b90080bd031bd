#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// Length of the shortest path from every cell to one goal, by breadth-first search [cells].
class DistanceField {
 public:
  static constexpr int kUnreachable = std::numeric_limits<std::int32_t>::max();

  /// @throws std::invalid_argument if the goal is not a free cell
  DistanceField(const Grid& grid, const Cell& goal);

  /// Distance [cells], or kUnreachable from obstacles, other components and outside.
  int at(const Cell& cell) const {
    if (cell.row < 0 || cell.row >= rows_ || cell.col < 0 || cell.col >= cols_) {
      return kUnreachable;
    }
    return distance_[static_cast<std::size_t>(cell.row * cols_ + cell.col)];
  }
  const Cell& goal() const { return goal_; }

 private:
  int rows_;
  int cols_;
  Cell goal_;
  std::vector<std::int32_t> distance_;
};

/// A shortest path by walking downhill, start first, goal last. Among equally short moves the first
/// in the order North, East, South, West is taken, so that paths repeat.
/// @return empty if the goal cannot be reached from `start`
std::vector<Cell> shortestPath(const DistanceField& field, const Cell& start);

}  // namespace sylph
