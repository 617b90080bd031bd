#include "sylph_core/grid/distance_field.hpp"

#include <stdexcept>

#include "sylph_core/grid/action.hpp"

namespace sylph {

DistanceField::DistanceField(const Grid& grid, const Cell& goal)
    : rows_(grid.rows()), cols_(grid.cols()), goal_(goal) {
  if (!grid.isFree(goal)) {
    throw std::invalid_argument("goal " + toString(goal) + " is not a free cell");
  }
  distance_.assign(static_cast<std::size_t>(grid.size()), kUnreachable);
  std::vector<Cell> frontier = {goal};
  distance_[static_cast<std::size_t>(grid.indexOf(goal))] = 0;
  for (std::size_t next = 0; next < frontier.size(); ++next) {
    const Cell cell = frontier[next];
    const std::int32_t distance = at(cell) + 1;
    for (const Action action : kActions) {
      const Cell reached = neighbor(cell, action);
      if (grid.isFree(reached) && at(reached) == kUnreachable) {
        distance_[static_cast<std::size_t>(grid.indexOf(reached))] = distance;
        frontier.push_back(reached);
      }
    }
  }
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
