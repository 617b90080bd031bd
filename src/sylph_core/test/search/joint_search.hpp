#pragma once

#include <optional>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"

namespace sylph {

// Dijkstra's algorithm over all joint configurations: for a handful of agents on a handful of
// cells. Shares no code with the planners.

/// The least number of agents and timesteps at which an agent does not rest on its goal, summed
/// over a plan; none if the instance has no solution.
std::optional<long> leastCostByJointSearch(const Instance& instance);

/// The least sum of the timesteps from which on agents rest on their goals; none likewise.
std::optional<long> leastSumOfCostsByJointSearch(const Instance& instance);

/// A map of up to 3 x 4 cells with up to `max_agents` agents, often so crowded that there is no
/// solution.
Instance crowdedInstance(int max_agents, bool rotations, Rng& rng);

}  // namespace sylph
