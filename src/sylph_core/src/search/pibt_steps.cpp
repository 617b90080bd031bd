#include "sylph_core/search/pibt_steps.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sylph {

PibtSteps::PibtSteps(Pibt& pibt, MoveRanking& ranking, const Vertices& configuration,
                     std::vector<AgentId> order)
    : pibt_(&pibt), ranking_(&ranking), configuration_(&configuration), order_(std::move(order)) {}

bool PibtSteps::generate(Vertices& to) {
  return pibt_->step(*configuration_, order_, *ranking_, to);
}

std::vector<AgentId> orderByPriority(const Priorities& priorities,
                                     const std::vector<double>& tie_breaks) {
  std::vector<AgentId> order(priorities.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](const AgentId a, const AgentId b) {
    if (priorities[a] != priorities[b]) {
      return priorities[a] > priorities[b];
    }
    if (tie_breaks[a] != tie_breaks[b]) {
      return tie_breaks[a] > tie_breaks[b];
    }
    // Down to the index, so that a seed gives the same plan with every sort.
    return a < b;
  });
  return order;
}

Priorities updatePriorities(const Priorities& priorities, const Vertices& configuration,
                            const Vertices& goals) {
  Priorities updated(priorities.size(), 0);
  for (std::size_t agent = 0; agent < priorities.size(); ++agent) {
    if (configuration[agent] != goals[agent]) {
      updated[agent] = priorities[agent] + 1;
    }
  }
  return updated;
}

}  // namespace sylph
