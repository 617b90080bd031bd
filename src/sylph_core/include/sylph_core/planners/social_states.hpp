#pragma once

#include <vector>

#include "sylph_core/mapf/types.hpp"
#include "sylph_core/search/search_problem.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

/// Social states of a plan that was found without them: partners by Alg. 1 and 2, SVOs unknown.
/// @return one per joint action
std::vector<SocialState> socialStatesOf(const SearchProblem& problem, const Grid& grid,
                                        const Plan& plan);

}  // namespace sylph
