#pragma once

#include <vector>

#include "sylph_core/grid/cell.hpp"

namespace sylph {

using AgentId = int;   ///< index of an agent in its instance, from 0
using Timestep = int;  ///< whole number from 0, no unit

/// The cell of every agent at one timestep.
using Configuration = std::vector<Cell>;

/// Configurations, starts first: plan[t][agent]. Agents rest in the last one.
using Plan = std::vector<Configuration>;

/// What the executor can do.
struct MotionModel {
  /// Whether three or more agents may rotate, each into the cell that the next one leaves. Standard
  /// MAPF allows it; robots that hold their start cell until they have arrived cannot do it.
  bool rotations = false;
};

}  // namespace sylph
