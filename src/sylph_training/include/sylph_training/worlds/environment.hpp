#pragma once

#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/policy/observation.hpp"
#include "sylph_core/social/partners.hpp"
#include "sylph_training/worlds/blocking.hpp"

namespace sylph_training {

/// Reward of an agent for one step. He et al. 2024 (arXiv:2408.03063), table "Reward Structure".
struct RewardOptions {
  double move = -0.3;              ///< to another cell, wherever that leads
  double stay_off_goal = -0.3;     ///< for each step of waiting
  double stay_on_goal = 0.0;       ///< for each step at rest
  double collision = -2.0;         ///< instead of the above, for who is to blame
  double blocking = -1.0;          ///< per agent blocked by one that rests on its goal
  int blocking_detour_cells = 10;  ///< a longer way round than this counts as blocked, >= 0
  /// R^a over cos(Z) + sin(Z), which makes it a mean. The paper's sum of costs is the least for the
  /// selfish whatever happens, and an SVO that learns from it hardly leaves 0.
  bool mean_by_svo = false;
  double svo_importance = 2.0;  ///< rho: the social reward is (own + partner's) / rho, > 0
};

/// Rules of an episode; what is off by default or can be taken away is an ablation.
struct EnvironmentOptions {
  RewardOptions rewards;
  bool tie_breaking = true;  ///< conflicts by SVO (Alg. 3); else all parties stay and are penalised
  bool partners = true;      ///< else everybody is its own partner
  bool prosocial_on_goal = true;  ///< others see the most prosocial level of who is on its goal
  int max_steps = 256;            ///< of an episode, > 0

  /// @throws std::invalid_argument naming the member and what is allowed
  void requireValid() const;
};

/// SVOs of one step, one entry per agent, 0 ... 45 [deg].
struct StepSvo {
  std::vector<float>
      mean_deg;  ///< of the distribution: orders tie-breaking, and is what others see
  std::vector<float> drawn_deg;  ///< Z, drawn from the distribution: weighs the rewards
};

/// What one step brought; one entry per agent.
struct StepOutcome {
  std::vector<sylph::Action> actions;    ///< those carried out: the desired one or Stay
  std::vector<bool> is_penalized;        ///< to blame for a collision that was averted
  std::vector<double> external_rewards;  ///< R^ex, the reward of the table
  std::vector<double> social_rewards;    ///< R^s = (own + partner's) / rho
  std::vector<double> action_rewards;    ///< R^a = cos(Z) own + sin(Z) partner's
};

/// One world in which agents learn: map, agents, goals, partners, SVOs. He et al. 2024
/// (arXiv:2408.03063), "Social Behavior Learning". An episode ends when all agents are on their
/// goals at the end of a step, or after `max_steps`.
class Environment {
 public:
  /// @param svo_deg     per agent the SVO that the others see before the first step [deg]
  /// @param tie_breaks  per agent, 0 ... 1; none given: all 0
  /// @throws std::invalid_argument if the instance, the options or a number of SVOs or tie
  /// breaks is not valid
  Environment(sylph::Instance instance, const EnvironmentOptions& options,
              std::vector<float> svo_deg, std::vector<float> tie_breaks = {});
  Environment(const Environment&) = delete;  // its parts refer to one another
  Environment& operator=(const Environment&) = delete;
  ~Environment() = default;

  const sylph::Instance& instance() const { return instance_; }
  /// Where each agent is.
  const sylph::Configuration& cells() const { return states_.cells; }
  /// Fixed partners (Alg. 2); an agent without partner is its own.
  const std::vector<sylph::AgentId>& partners() const { return partner_ids_; }
  /// Overlap of an agent's way with its partner's, 0 without partner.
  double partnerOverlap(sylph::AgentId agent) const;
  bool isOnGoal(sylph::AgentId agent) const;
  /// Agents on their goals now.
  int arrivedCount() const;
  /// Per agent on its goal the number of agents that it blocks there; 0 elsewhere.
  const std::vector<int>& blockedCounts() const { return blocked_; }
  /// Whether the action leads to a free cell of the map, whoever stands there.
  bool isValid(sylph::AgentId agent, sylph::Action action) const;
  /// See sylph::ObservationEncoder::encode().
  void encode(sylph::AgentId agent, float* view, float* vector) const;

  /// Of this episode, so far.
  int stepCount() const { return step_count_; }
  /// Whether all agents are on their goals.
  bool isSolved() const { return arrivedCount() == instance_.agentCount(); }
  /// Whether the episode is over.
  bool isFinished() const { return isSolved() || step_count_ >= options_.max_steps; }

  /// Carries out a joint action, less what would collide.
  /// @param desired  one per agent
  /// @throws std::invalid_argument if the sizes differ, std::logic_error if the episode is over
  StepOutcome step(const std::vector<sylph::Action>& desired, const StepSvo& svo);

 private:
  double externalReward(std::size_t agent, const StepOutcome& outcome) const;
  void shareRewards(const std::vector<float>& drawn_svo_deg, StepOutcome& outcome) const;
  void showSvo(const std::vector<float>& svo_deg);
  void updatePartners();
  void updatePriorities();

  sylph::Instance instance_;
  EnvironmentOptions options_;
  std::vector<sylph::DistanceField> distances_;
  sylph::AgentStates states_;
  sylph::ObservationEncoder encoder_;
  sylph::Partners partners_;
  std::vector<sylph::AgentId> partner_ids_;
  BlockingTest blocking_;
  std::vector<int> blocked_;
  int step_count_ = 0;
};

}  // namespace sylph_training
