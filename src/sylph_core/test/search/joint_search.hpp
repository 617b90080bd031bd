#pragma once

#include "sylph_core/mapf/instance.hpp"

namespace sylph {

/// Whether an instance has a solution, by breadth-first search over all joint configurations.
/// For a handful of agents on a handful of cells; shares no code with the planners.
bool isSolvableByJointSearch(const Instance& instance);

}  // namespace sylph
