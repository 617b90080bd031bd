#include "sylph_core/search/policy_ranking.hpp"

#include <algorithm>

#include "sylph_core/grid/action.hpp"

namespace sylph {
namespace {

constexpr double kPatience = 20.0;         // [timesteps]
constexpr double kTemperatureRise = 60.0;  // [timesteps]

}  // namespace

PolicyRanking::PolicyRanking(const SearchProblem& problem, const MoveSettings& settings,
                             const AgentRows& actions, const Priorities& priorities, Rng& rng)
    : problem_(&problem),
      settings_(&settings),
      actions_(&actions),
      priorities_(&priorities),
      rng_(&rng) {}

void PolicyRanking::rank(AgentId agent, VertexId at, const Occupants& occupied_now, Moves& moves) {
  const Cell& cell = problem_->graph.cellAt(at);
  const int to_go = problem_->distances.get(agent, at);
  const double temperature = temperatureOf(agent, at, occupied_now);
  sortMoves(moves, [&](VertexId target) {
    const Action action = *actionBetween(cell, problem_->graph.cellAt(target));
    double key = static_cast<double>((*actions_)(agent, static_cast<Eigen::Index>(action))) +
                 settings_->distance_weight * (to_go - problem_->distances.get(agent, target));
    if (action == Action::Stay && to_go > 0) {
      key -= settings_->stay_penalty;
    }
    if (temperature > 0.0) {
      key += temperature * drawGumbel(*rng_);
    }
    return -key;
  });
}

double PolicyRanking::temperatureOf(AgentId agent, VertexId at,
                                    const Occupants& occupied_now) const {
  // That of the neighbours counts too: who is in the way of a stuck agent has to try other moves
  // as well.
  int priority = (*priorities_)[agent];
  for (const VertexId beside : problem_->graph.neighbors(at)) {
    if (occupied_now[beside] != kNoAgent) {
      priority = std::max(priority, (*priorities_)[occupied_now[beside]]);
    }
  }
  return settings_->base_temperature * std::clamp((priority - kPatience) / kTemperatureRise,
                                                  settings_->least_factor, settings_->most_factor);
}

}  // namespace sylph
