#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// Length of the shortest path from every cell to one goal, by breadth-first search [cells].
///
/// The search goes on only as far as it is asked for, so that fields of large maps cost what their
/// agents' ways need. Not to be shared between threads before complete().
class DistanceField {
 public:
  /// More than any distance.
  static constexpr int kUnreachable = std::numeric_limits<std::int32_t>::max();

  /// @param grid  must outlive this object
  /// @throws std::invalid_argument if the goal is not a free cell
  DistanceField(const Grid& grid, const Cell& goal);
  DistanceField(Grid&& grid, const Cell& goal) = delete;

  /// Distance [cells], or kUnreachable from obstacles, other components and outside.
  int at(const Cell& cell) const {
    return grid_->isInside(cell) ? atIndex(grid_->indexOf(cell)) : kUnreachable;
  }
  /// Likewise, from a row-major index inside the grid.
  int atIndex(int index) const {
    const auto slot = static_cast<std::size_t>(index);
    if (slot >= distance_.size() || distance_[slot] == kUnknown) {
      searchUntil(slot);
    }
    return distance_[slot];
  }
  /// To which the distances are.
  const Cell& goal() const { return goal_; }

  /// Searches as far as a cell inside the grid, so that at() has the answer.
  /// @param isOver  asked now and then; whether to break off
  /// @return whether that is done
  bool reach(const Cell& cell, const std::function<bool()>& isOver) const;

  /// Searches the whole grid. As reach().
  bool complete(const std::function<bool()>& isOver = [] { return false; }) const;

 private:
  static constexpr std::int32_t kUnknown = -1;

  void begin() const;
  void searchUntil(std::size_t slot) const;
  void spreadOnce() const;

  const Grid* grid_;
  Cell goal_;
  mutable std::vector<std::int32_t> distance_;  // row-major, empty before the first question
  mutable std::vector<Cell> frontier_;          // the farthest cells known; empty when complete
  mutable std::vector<Cell> next_;              // scratch of spreadOnce()
};

/// One field for each goal; `grid` must outlive them.
/// @throws std::invalid_argument if a goal is not a free cell
std::vector<DistanceField> distancesTo(const std::vector<Cell>& goals, const Grid& grid);

/// A shortest path by walking downhill, start first, goal last. Among equally short moves the first
/// in the order North, East, South, West is taken, so that paths repeat.
/// @return empty if the goal cannot be reached from `start`
std::vector<Cell> shortestPath(const DistanceField& field, const Cell& start);

}  // namespace sylph
