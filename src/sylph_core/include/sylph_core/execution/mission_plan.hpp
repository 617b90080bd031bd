#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/mapf/types.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

/// A plan as it reaches the executor.
struct MissionPlan {
  std::uint32_t plan_id = 0;           ///< from 1, greater for each new plan
  std::uint32_t replaces_plan_id = 0;  ///< plan from whose commit cut it starts; 0: a new mission
  std::uint32_t first_step = 0;  ///< timestep of the replaced plan that plan[0] stands for; only 0
  std::string planner;
  double planning_s = 0.0;          ///< wall time of planning [s]
  std::vector<std::string> robots;  ///< name of each agent
  Configuration goals;              ///< per agent
  Plan plan;                        ///< configurations, starts first; at least one
  std::vector<SocialState> social;  ///< one per joint action; partners are agents of this plan

  /// Number of joint actions.
  std::uint32_t steps() const {
    return plan.empty() ? 0 : static_cast<std::uint32_t>(plan.size() - 1);
  }
};

}  // namespace sylph
