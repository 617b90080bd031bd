#include "sylph_training/imitation/team_state.hpp"

#include <utility>

#include "sylph_core/social/precedence.hpp"
#include "sylph_core/social/tie_breaking.hpp"

namespace sylph_training {

using sylph::Action;
using sylph::AgentId;

TeamState::TeamState(const sylph::Instance& instance, const sylph::SearchProblem& problem,
                     std::vector<float> tie_breaks)
    : instance_(&instance), problem_(&problem), before_(instance.starts) {
  states_.cells = instance.starts;
  states_.last_moves.assign(instance.starts.size(), Action::Stay);
  states_.priorities.assign(instance.starts.size(), 0);
  states_.svo_deg.resize(instance.starts.size());
  states_.tie_breaks = std::move(tie_breaks);
  updateSvo();
}

bool TeamState::isHome(AgentId agent) const {
  const auto index = static_cast<std::size_t>(agent);
  return states_.cells[index] == instance_->goals[index];
}

bool TeamState::isSolved() const {
  return states_.cells == instance_->goals;
}

bool TeamState::isValid(AgentId agent, Action action) const {
  return instance_->grid.isFree(neighbor(states_.cells[static_cast<std::size_t>(agent)], action));
}

bool TeamState::isGreedy(AgentId agent, Action action) const {
  if (isHome(agent)) {
    return action == Action::Stay;
  }
  const sylph::Cell& cell = states_.cells[static_cast<std::size_t>(agent)];
  const auto distance = [&](const sylph::Cell& at) {
    return problem_->distances.get(agent, problem_->graph.vertexAt(at));
  };
  return isValid(agent, action) && distance(neighbor(cell, action)) < distance(cell);
}

void TeamState::move(const std::vector<Action>& desired, const std::vector<float>& svo_deg) {
  const sylph::TieBreaking broken =
      breakTies(instance_->grid, instance_->motion, states_.cells, desired, svo_deg);
  before_ = states_.cells;
  for (std::size_t agent = 0; agent < desired.size(); ++agent) {
    states_.cells[agent] = neighbor(states_.cells[agent], broken.actions[agent]);
  }
  states_.last_moves = broken.actions;
  updateSvo();
}

void TeamState::updateSvo() {
  for (std::size_t agent = 0; agent < states_.cells.size(); ++agent) {
    states_.priorities[agent] =
        isHome(static_cast<AgentId>(agent)) ? 0 : states_.priorities[agent] + 1;
    states_.svo_deg[agent] =
        sylph::svoByPriority(states_.priorities[agent], states_.tie_breaks[agent]);
  }
}

}  // namespace sylph_training
