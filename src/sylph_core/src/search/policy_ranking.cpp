#include "sylph_core/search/policy_ranking.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sylph_core/grid/action.hpp"

namespace sylph {
namespace {

constexpr double kPatience = 20.0;     // [timesteps]
constexpr double kHeatingTime = 60.0;  // [timesteps]

}  // namespace

PolicyRanking::PolicyRanking(const SearchProblem& problem, const MoveSettings& settings, Rng& rng)
    : problem_(&problem),
      settings_(settings),
      rng_(&rng),
      occupant_(static_cast<std::size_t>(problem.graph.size()), kNoAgent) {}

void PolicyRanking::listenTo(const AgentRows& actions, const std::vector<int>& waited) {
  actions_ = &actions;
  waited_ = &waited;
}

void PolicyRanking::observe(const Vertices& configuration) {
  for (const VertexId vertex : observed_) {
    occupant_[vertex] = kNoAgent;
  }
  observed_ = configuration;
  for (std::size_t agent = 0; agent < configuration.size(); ++agent) {
    occupant_[configuration[agent]] = static_cast<AgentId>(agent);
  }
}

void PolicyRanking::rank(AgentId agent, VertexId at, Moves& moves) {
  const Cell& cell = problem_->graph.cellAt(at);
  const int to_go = problem_->distances.get(agent, at);
  const double temperature = temperatureOf(agent, at);
  std::array<double, kActionCount> keys{};
  for (int index = 0; index < moves.count; ++index) {
    const VertexId target = moves.targets[index];
    const Action action = *actionBetween(cell, problem_->graph.cellAt(target));
    double key = static_cast<double>((*actions_)(agent, static_cast<Eigen::Index>(action))) +
                 settings_.distance_weight * (to_go - problem_->distances.get(agent, target));
    if (action == Action::Stay && to_go > 0) {
      key -= settings_.stay_penalty;
    }
    if (temperature > 0.0) {
      key += temperature * drawGumbel();
    }
    int slot = index;
    for (; slot > 0 && keys[slot - 1] < key; --slot) {
      keys[slot] = keys[slot - 1];
      moves.targets[slot] = moves.targets[slot - 1];
    }
    keys[slot] = key;
    moves.targets[slot] = target;
  }
}

double PolicyRanking::temperatureOf(AgentId agent, VertexId at) const {
  double waited = (*waited_)[agent];
  for (const VertexId beside : problem_->graph.neighbors(at)) {
    if (occupant_[beside] != kNoAgent) {
      waited = std::max<double>(waited, (*waited_)[occupant_[beside]]);
    }
  }
  return settings_.base_temperature *
         std::clamp((waited - kPatience) / kHeatingTime, settings_.least_heat, settings_.most_heat);
}

double PolicyRanking::drawGumbel() {
  constexpr double kHalfStep = 0.5 / 4294967296.0;  // keeps the fraction off 0
  return -std::log(-std::log(drawFraction(*rng_) + kHalfStep));
}

}  // namespace sylph
