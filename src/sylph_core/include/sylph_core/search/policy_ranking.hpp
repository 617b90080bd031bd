#pragma once

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/policy/network.hpp"
#include "sylph_core/search/configuration_generator.hpp"
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
/// The temperature of an agent is base_temperature * clamp((priority - 20) / 60, least_factor,
/// most_factor), where `priority` is its own or that of an agent beside it, whichever is higher:
/// whoever gets nowhere tries something else, and so does whoever has to make way.
struct MoveSettings {
  double distance_weight = 8.0;   ///< of a cell nearer to the goal, in logits
  double stay_penalty = 2.0;      ///< against waiting off the goal, in logits
  double base_temperature = 0.5;  ///< >= 0
  double least_factor = 0.1;      ///< equal to most_factor: the same temperature for all
  double most_factor = 2.0;       ///< so much room for chance where agents get nowhere
};

/// Prefers what the policy network prefers in one configuration, see MoveSettings.
class PolicyRanking : public MoveRanking {
 public:
  /// All arguments by reference must outlive this object.
  /// @param actions  n x 5 logits, in the order of Action
  PolicyRanking(const SearchProblem& problem, const MoveSettings& settings,
                const AgentRows& actions, const Priorities& priorities, Rng& rng);

  void rank(AgentId agent, VertexId at, const Occupants& occupied_now, Moves& moves) override;

 private:
  double temperatureOf(AgentId agent, VertexId at, const Occupants& occupied_now) const;

  const SearchProblem* problem_;
  const MoveSettings* settings_;
  const AgentRows* actions_;
  const Priorities* priorities_;
  Rng* rng_;
};

}  // namespace sylph
