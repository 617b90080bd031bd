#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include "sylph_core/geometry/vector2.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph_planner_node {

/// The map as RViz and others know it: 0 free, 100 obstacle, one entry a cell, first entry at the
/// lower left corner. The stamp is left to the caller.
/// @param corner  where the lower left corner lies in frame `map` [m]
nav_msgs::OccupancyGrid toOccupancyGrid(const sylph::Grid& grid, double cell_size_m,
                                        const sylph::Point& corner = {});

}  // namespace sylph_planner_node
