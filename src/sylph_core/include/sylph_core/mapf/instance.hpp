#pragma once

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// A multi-agent path finding problem: agent i goes from starts[i] to goals[i].
struct Instance {
  Grid grid;             ///< the map
  Configuration starts;  ///< per agent, distinct free cells
  Configuration goals;   ///< per agent, distinct free cells
  MotionModel motion;    ///< which joint steps are legal

  /// As many as there are starts.
  int agentCount() const { return static_cast<int>(starts.size()); }
};

/// Refuses what no planner can be asked.
/// @throws std::invalid_argument naming the agent: starts and goals of unequal number or none at
/// all, a start or goal outside the map or on an obstacle, two equal starts, two equal goals, a
/// goal that cannot be reached from its start
void requireValid(const Instance& instance);

}  // namespace sylph
