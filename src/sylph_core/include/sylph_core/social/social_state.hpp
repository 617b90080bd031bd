#pragma once

#include <vector>

#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Partners and social value orientations at one timestep.
struct SocialState {
  std::vector<AgentId> partners;  ///< per agent; an agent without partner is its own
  std::vector<float> svo_deg;  ///< per agent, 0 selfish ... 45 prosocial [deg]; NaN where unknown
};

}  // namespace sylph
