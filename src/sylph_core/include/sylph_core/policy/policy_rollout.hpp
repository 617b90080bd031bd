#pragma once

#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/policy/observation.hpp"
#include "sylph_core/policy/policy.hpp"
#include "sylph_core/social/partners.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

/// Which SVO agents act by while off their goals: one of the distribution that the policy gives or,
/// to compare with, one that it has no say in. The random ones are levels, each as likely, as in He
/// et al. 2024 (arXiv:2408.03063), "Paired t-test".
enum class SvoChoice {
  Mean,              ///< the policy's mean angle
  Sample,            ///< a level, drawn from the policy's distribution
  Priority,          ///< by the rule of priorities, see svoByPriority()
  RandomPerStep,     ///< drawn anew at each step
  RandomPerEpisode,  ///< drawn once
  RandomPerPartner,  ///< drawn anew whenever the agent's partner changes, or it leaves its goal
};

/// What is wanted of a step.
enum class StepUse {
  Social,  ///< all but `by_cost`, which then is `actions`
  Search,  ///< `by_cost` as well: twice the work where there is a cost network
};

/// What the policy says in one configuration, and what it takes along to the next one.
struct PolicyStep {
  AgentRows actions;            ///< n x 5 logits, in the order of Action: for who resolves by SVO
  AgentRows by_cost;            ///< n x 5 logits: of the cost network; `actions` without one
  AgentRows svo;                ///< n x levels, each row of sum 1
  AgentRows memory;             ///< n x width, or empty if the policy has none
  std::vector<int> priorities;  ///< per agent: timesteps since it was last on its goal
  SocialState social;           ///< fixed partners, SVOs that agents act by
};

/// The policy of all agents of an instance, from one configuration to the next: observation,
/// partners, one call of the network, SVO.
///
/// The network sees the SVO distributions of the step before; at the start, what the rule of
/// waiting gives. An agent on its goal takes the most prosocial level, whatever the network says,
/// and that is also what the network gets to see of it.
class PolicyRollout {
 public:
  /// @param policy, grid  must outlive this object, as distances must
  /// @param distances  per agent the distances to its goal
  /// @param threads    that the network may use, > 0
  /// @param rng        draws the agents' tie breaks
  PolicyRollout(const Policy& policy, const Grid& grid, const std::vector<DistanceField>& distances,
                SvoChoice svo_choice, int threads, Rng& rng);

  /// What goes before the first step.
  PolicyStep nothingKnown() const;

  /// The step in `to`, one timestep after the step `before` in `from`; the first one comes after
  /// nothingKnown() in the same configuration. Steps need not follow each other in the order of the
  /// calls: a search can come back to any one.
  /// @throws std::invalid_argument if the number of agents is another
  PolicyStep follow(const PolicyStep& before, const Configuration& from, const Configuration& to,
                    Rng& rng, StepUse use = StepUse::Search);

  /// Per agent a number between 0 and 1 that tells it from others in an equal place.
  const std::vector<float>& tieBreaks() const { return tie_breaks_; }
  /// How often the network has been asked.
  long calls() const { return calls_; }

 private:
  PolicyStep evaluate(AgentStates states, NetworkInput input, StepUse use, Rng& rng);
  float assigned(std::size_t agent, int priority, const PolicyStep& before, Rng& rng) const;
  float actedBy(const float* probabilities, Rng& rng) const;

  const Policy* policy_;
  SvoChoice svo_choice_;
  int threads_;
  const std::vector<DistanceField>* distances_;
  ObservationEncoder encoder_;
  Partners partners_;
  std::vector<float> tie_breaks_;
  std::vector<float> episode_svo_deg_;  // where it is drawn once
  long calls_ = 0;
};

}  // namespace sylph
