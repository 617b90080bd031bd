#pragma once

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Distinct free cells, each set of them equally likely.
/// @throws std::invalid_argument if `count` is not in 0 ... number of free cells
Configuration drawCells(const Grid& grid, int count, Rng& rng);

/// For each given cell one that can be reached from it, all of them distinct. An agent may draw the
/// cell that it stands on.
/// @param from  distinct free cells
/// @throws std::invalid_argument if they are not
Configuration drawReachableCells(const Grid& grid, const Configuration& from, Rng& rng);

/// Random starts, and random goals in the component of each start.
/// @throws std::invalid_argument if `agents` is not in 1 ... number of free cells
Instance randomInstance(const Grid& grid, int agents, const MotionModel& motion, Rng& rng);

}  // namespace sylph
