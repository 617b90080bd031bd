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
/// The temperature of an agent is base_temperature * clamp((waited - 20) / 60, least_heat,
/// most_heat), where it or one beside it has been off its goal for `waited` timesteps: whoever gets
/// nowhere tries something else, and so does whoever has to make way.
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

  /// What the network says in the configuration that is observed next.
  /// @param actions  n x 5 logits; must outlive the questions, as must `waited`
  /// @param waited   per agent: timesteps since it was last on its goal
  void listenTo(const AgentRows& actions, const std::vector<int>& waited);

  void observe(const Vertices& configuration) override;
  void rank(AgentId agent, VertexId at, Moves& moves) override;

 private:
  double temperatureOf(AgentId agent, VertexId at) const;
  double drawGumbel();

  const SearchProblem* problem_;
  MoveSettings settings_;
  Rng* rng_;
  const AgentRows* actions_ = nullptr;
  const std::vector<int>* waited_ = nullptr;
  std::vector<AgentId> occupant_;  // per vertex
  Vertices observed_;
};

}  // namespace sylph
