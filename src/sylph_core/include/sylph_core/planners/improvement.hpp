#pragma once

#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/planners/generator_factory.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/improvement_settings.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// What improvement came to.
struct Improvement {
  std::vector<Vertices> plan;  ///< the cheapest known
  bool is_least = false;       ///< by exhaustive search
  long improvements = 0;       ///< times a better plan was found
  long nodes = 0;              ///< configurations generated
};

/// Lowers the sum of costs of a solution until the time is up or it is known to be the least.
///
/// First LaCAM restarts from configurations of the plan with other orders of the agents, while that
/// helps. Then, in turns: large-neighbourhood search, which does most of the work, and LaCAM*,
/// whose known configurations take in each better plan and rewire it; on small instances LaCAM*
/// sees everything and proves the optimum. With more than one thread, as many large-neighbourhood
/// searches run at once with different random numbers and go on from the best of their solutions
/// after each turn.
/// @param plan                 a legal plan that ends on the goals
/// @param proved_sum_of_costs  no plan has less, besides the sum of distances: then it ends
Improvement improve(const SearchProblem& problem, std::vector<Vertices> plan,
                    const GeneratorFactory& make_generator, int threads, const Deadline& deadline,
                    Rng& rng, long proved_sum_of_costs = 0,
                    const ImprovementSettings& settings = {});

}  // namespace sylph
