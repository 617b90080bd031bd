#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include "sylph_core/grid/grid.hpp"

namespace sylph_planner_node {

/// The map as RViz and others know it: 0 free, 100 obstacle, one entry a cell, first entry at the
/// lower left corner, which is the origin of frame `map`. The stamp is left to the caller.
nav_msgs::OccupancyGrid toOccupancyGrid(const sylph::Grid& grid, double cell_size_m);

}  // namespace sylph_planner_node
