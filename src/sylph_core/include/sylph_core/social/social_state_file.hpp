#pragma once

#include <string>
#include <vector>

#include "sylph_core/mapf/types.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

/// Writes where agents are and what they are to each other, as CSV: a header, then a line for each
/// timestep and agent, `step,agent,row,col,partner,svo_deg`. `partner` is the agent itself where it
/// has none.
/// @param social  per joint action of the plan, or the first ones; later steps are left out
/// @throws std::runtime_error naming the file if it cannot be written
void saveSocialStates(const Plan& plan, const std::vector<SocialState>& social,
                      const std::string& path);

}  // namespace sylph
