#include "sylph_core/planners/social_states.hpp"

#include <limits>
#include <numeric>

namespace sylph {

std::vector<SocialState> unknownSocialStates(const Plan& plan) {
  if (plan.size() < 2) {
    return {};
  }
  SocialState state;
  state.partners.resize(plan.front().size());
  std::iota(state.partners.begin(), state.partners.end(), 0);
  state.svo_deg.assign(plan.front().size(), std::numeric_limits<float>::quiet_NaN());
  return std::vector<SocialState>(plan.size() - 1, state);
}

}  // namespace sylph
