#include "sylph_core/policy/occupancy_map.hpp"

namespace sylph {

OccupancyMap::OccupancyMap(const Grid& grid, int margin)
    : margin_(margin), stride_(grid.cols() + 2 * margin), steps_{-stride_, 1, stride_, -1} {
  const auto size = static_cast<std::size_t>(stride_ * (grid.rows() + 2 * margin));
  // The margin is obstacle, so that a field of view needs no look at the map's edges.
  is_obstacle_.assign(size, 1);
  occupants_.assign(size, -1);
  for (const Cell& cell : grid.freeCells()) {
    is_obstacle_[static_cast<std::size_t>(indexOf(cell))] = 0;
  }
}

void OccupancyMap::place(const Configuration& cells) {
  for (const int index : occupied_) {
    occupants_[static_cast<std::size_t>(index)] = -1;
  }
  occupied_.clear();
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    occupied_.push_back(indexOf(cells[agent]));
    occupants_[static_cast<std::size_t>(occupied_.back())] = static_cast<AgentId>(agent);
  }
}

}  // namespace sylph
