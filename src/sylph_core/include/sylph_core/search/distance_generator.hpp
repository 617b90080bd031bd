#pragma once

#include <memory>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// PIBT by distance to the goal: the generator of the planners without a network. Agents of equal
/// priority choose by distance, farthest first, or from the second attempt on in random order.
/// @param problem, rng  must outlive the result
std::unique_ptr<ConfigurationGenerator> makeDistanceGenerator(const SearchProblem& problem,
                                                              int attempt, Rng& rng);

}  // namespace sylph
