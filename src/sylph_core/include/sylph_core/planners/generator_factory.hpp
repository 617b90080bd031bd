#pragma once

#include <functional>
#include <memory>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/configuration_generator.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// What tells one kind of planner from another: how a joint step comes about.
/// The problem and the generator of random numbers outlive the result. Searches that get nowhere
/// start anew: `attempt`, from 0, counts how often, and each one should do something else.
using GeneratorFactory = std::function<std::unique_ptr<ConfigurationGenerator>(
    const SearchProblem& problem, int attempt, Rng& rng)>;

}  // namespace sylph
