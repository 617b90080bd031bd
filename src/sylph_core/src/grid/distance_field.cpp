#include "sylph_core/grid/distance_field.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sylph_core/grid/action.hpp"

namespace sylph {

DistanceField::DistanceField(const Grid& grid, const Cell& goal) : grid_(&grid), goal_(goal) {
  if (!grid.isFree(goal)) {
    throw std::invalid_argument("goal " + toString(goal) + " is not a free cell");
  }
}

bool DistanceField::reach(const Cell& cell, const std::function<bool()>& isOver) const {
  if (distance_.empty()) {
    begin();
  }
  const std::int32_t& distance = distance_[static_cast<std::size_t>(grid_->indexOf(cell))];
  // Breadth-first search that goes on where it was left: on a large map most of a field is never
  // asked for.
  while (distance == kUnknown && !isOver()) {
    spreadOnce();
  }
  return distance != kUnknown;
}

bool DistanceField::complete(const std::function<bool()>& isOver) const {
  if (distance_.empty()) {
    begin();
  }
  while (!frontier_.empty() && !isOver()) {
    spreadOnce();
  }
  return frontier_.empty();
}

void DistanceField::begin() const {
  distance_.assign(static_cast<std::size_t>(grid_->size()), kUnreachable);
  for (int row = 0; row < grid_->rows(); ++row) {
    for (int col = 0; col < grid_->cols(); ++col) {
      if (grid_->isFree({row, col})) {
        distance_[static_cast<std::size_t>(grid_->indexOf({row, col}))] = kUnknown;
      }
    }
  }
  distance_[static_cast<std::size_t>(grid_->indexOf(goal_))] = 0;
  frontier_ = {goal_};
}

void DistanceField::searchUntil(std::size_t slot) const {
  if (distance_.empty()) {
    begin();
  }
  while (distance_[slot] == kUnknown) {
    spreadOnce();
  }
}

// By one cell; where there is none left, what is unknown is unreachable.
void DistanceField::spreadOnce() const {
  const std::int32_t distance = atIndex(grid_->indexOf(frontier_.front())) + 1;
  next_.clear();
  for (const Cell& cell : frontier_) {
    for (const Action action : kActions) {
      const Cell reached = neighbor(cell, action);
      if (!grid_->isInside(reached)) {
        continue;
      }
      std::int32_t& known = distance_[static_cast<std::size_t>(grid_->indexOf(reached))];
      if (known == kUnknown) {
        known = distance;
        next_.push_back(reached);
      }
    }
  }
  std::swap(frontier_, next_);
  if (frontier_.empty()) {
    std::replace(distance_.begin(), distance_.end(), kUnknown, std::int32_t{kUnreachable});
  }
}

std::vector<DistanceField> distancesTo(const std::vector<Cell>& goals, const Grid& grid) {
  std::vector<DistanceField> fields;
  fields.reserve(goals.size());
  for (const Cell& goal : goals) {
    fields.emplace_back(grid, goal);
  }
  return fields;
}

std::vector<Cell> shortestPath(const DistanceField& field, const Cell& start) {
  if (field.at(start) == DistanceField::kUnreachable) {
    return {};
  }
  std::vector<Cell> path = {start};
  while (field.at(path.back()) > 0) {
    const Cell cell = path.back();
    for (const Action action : kActions) {
      if (field.at(neighbor(cell, action)) == field.at(cell) - 1) {
        path.push_back(neighbor(cell, action));
        break;
      }
    }
  }
  return path;
}

}  // namespace sylph
