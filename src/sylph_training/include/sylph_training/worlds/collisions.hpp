#pragma once

#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/social/tie_breaking.hpp"

namespace sylph_training {

/// A joint action without conflicts where nobody gives way to anybody: everybody whose move is
/// invalid (obstacle, boundary) or part of a conflict (vertex, edge; a rotation if those are
/// refused) stays and is penalised, and so on until no conflict is left. What the ablation without
/// tie-breaking does instead of sylph::breakTies().
///
/// @param cells   distinct free cells of the agents
/// @param desired  one action per agent
/// @throws std::invalid_argument if the sizes differ
sylph::TieBreaking haltCollisions(const sylph::Grid& grid, const sylph::MotionModel& motion,
                                  const sylph::Configuration& cells,
                                  const std::vector<sylph::Action>& desired);

}  // namespace sylph_training
