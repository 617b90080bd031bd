#pragma once

#include <vector>

#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// Social states of a plan whose planner has no opinion: nobody has a partner, no SVO is known.
/// @return one per joint action
std::vector<SocialState> unknownSocialStates(const Plan& plan);

}  // namespace sylph
