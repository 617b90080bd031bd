#pragma once

#include <cstdint>
#include <vector>

#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/improvement_settings.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// Agents, as bits, that are late by so much in all.
struct DelayOfAgents {
  std::uint32_t agents;
  int delay;  ///< [timesteps], at least
};

/// The least sum of delays of a team whose groups are late by what is known of them: the minimum of
/// sum x_i over whole numbers x_i >= 0 with sum of x_i over a group >= its delay.
/// @param groups  may overlap
/// @return a smaller number, which holds as well, where the exact one would take too long
int leastTeamDelay(const std::vector<DelayOfAgents>& groups, int agents);

/// The largest sum of costs that is proved to be no more than that of any plan. An agent's cost is
/// the timestep from which on it rests on its goal.
///
/// From what pairs, groups of three and groups of four would cost alone on the map, as far as there
/// is time. The weighted dependency graph of Li et al. 2019 ("Improved Heuristics for Multi-Agent
/// Path Finding with Conflict-Based Search") goes as far as pairs.
/// @param enough    the cost of a plan: nothing beyond it is looked for
/// @param settings  those of the proof
/// @return the sum of distances where map or team are too large: see PairCosts
long provedSumOfCosts(const SearchProblem& problem, long enough, const Deadline& deadline,
                      const ImprovementSettings& settings = {});

}  // namespace sylph
