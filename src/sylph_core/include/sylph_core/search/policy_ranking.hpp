#pragma once

#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/policy/network.hpp"
#include "sylph_core/search/move_ranking.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// How the network's preferences and the way to go become an order of moves. A move's key is
///
///     logit + distance_weight * (cells that it comes closer to the goal)
///           - stay_penalty * [it is a stay off the goal] + temperature * g
///
/// with g drawn from the standard Gumbel distribution: without the two terms in the middle the move
/// with the largest key is a draw from softmax(logits / temperature). With a large distance_weight
/// the network settles which of the equally short moves to take and overrules the distance only
/// where it is sure.
///
/// An agent that has been off its goal for `waited` timesteps has the temperature
/// base_temperature * clamp((waited - 20) / 60, least_heat, most_heat): whoever gets nowhere tries
/// something else.
struct MoveSettings {
  double distance_weight = 8.0;
  double stay_penalty = 2.0;
  double base_temperature = 0.5;  ///< >= 0
  double least_heat = 0.1;        ///< equal to most_heat: the same temperature for all
  double most_heat = 2.0;
};

/// Prefers what the policy network prefers, see MoveSettings.
class PolicyRanking : public MoveRanking {
 public:
  /// @param problem, rng  must outlive this object
  PolicyRanking(const SearchProblem& problem, const MoveSettings& settings, Rng& rng);

  /// What the network says in the configuration that is asked about next.
  /// @param actions  n x 5 logits; must outlive the questions, as must `waited`
  /// @param waited   per agent: timesteps since it was last on its goal
  void listenTo(const AgentRows& actions, const std::vector<int>& waited);

  void observe(const Vertices& configuration) override;
  void rank(AgentId agent, VertexId at, Moves& moves) override;

 private:
  double temperatureOf(AgentId agent) const;
  double drawGumbel();

  const SearchProblem* problem_;
  MoveSettings settings_;
  Rng* rng_;
  const AgentRows* actions_ = nullptr;
  const std::vector<int>* waited_ = nullptr;
};

}  // namespace sylph
