#pragma once

#include <memory>

#include "sylph_core/planners/guide.hpp"
#include "sylph_core/policy/policy.hpp"
#include "sylph_core/policy/policy_rollout.hpp"
#include "sylph_core/search/policy_ranking.hpp"

namespace sylph {

/// How a policy's joint steps come about.
enum class PolicyUse {
  TieBreaking,  ///< all agents choose by themselves, SVO-based tie-breaking takes out the conflicts
  Pibt,         ///< PIBT, whose agents want what the network says
  Search,       ///< likewise, by distance instead where a search gets nowhere with it
};

/// How a planner is guided by its policy.
struct PolicySettings {
  MoveSettings moves;                      ///< how agents rank their moves
  SvoChoice svo_choice = SvoChoice::Mean;  ///< by which SVO they act
  bool breaks_ties_by_svo = true;          ///< or as if SVOs were drawn anew for each joint step
};

/// The settings that serve each use best.
/// @param has_cost_network  whether what agents want inside PIBT is what is cheap
PolicySettings defaultSettings(PolicyUse use, bool has_cost_network);

/// Joint steps, partners and SVOs by the policy network.
GuideFactory makePolicyGuideFactory(std::shared_ptr<const Policy> policy, PolicyUse use,
                                    const PolicySettings& settings);

}  // namespace sylph
