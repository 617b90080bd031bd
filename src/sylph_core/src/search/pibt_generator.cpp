#include "sylph_core/search/pibt_generator.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sylph {

PibtGenerator::PibtGenerator(Pibt pibt, MoveRanking& ranking, std::vector<double> tie_breaks)
    : pibt_(std::move(pibt)), ranking_(&ranking), tie_breaks_(std::move(tie_breaks)) {}

std::vector<AgentId> PibtGenerator::order(const Vertices& /*configuration*/,
                                          const Vertices* /*before*/,
                                          const std::vector<int>& waited) {
  return orderByWaiting(waited, tie_breaks_);
}

bool PibtGenerator::generate(const Vertices& from, const std::vector<AgentId>& order,
                             Vertices& to) {
  return pibt_.step(from, order, *ranking_, to);
}

std::vector<AgentId> orderByWaiting(const std::vector<int>& waited,
                                    const std::vector<double>& tie_breaks) {
  std::vector<AgentId> order(waited.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](const AgentId a, const AgentId b) {
    if (waited[a] != waited[b]) {
      return waited[a] > waited[b];
    }
    if (tie_breaks[a] != tie_breaks[b]) {
      return tie_breaks[a] > tie_breaks[b];
    }
    return a < b;
  });
  return order;
}

std::vector<int> updateWaited(const std::vector<int>& waited, const Vertices& configuration,
                              const Vertices& goals) {
  std::vector<int> updated(waited.size(), 0);
  for (std::size_t agent = 0; agent < waited.size(); ++agent) {
    if (configuration[agent] != goals[agent]) {
      updated[agent] = waited[agent] + 1;
    }
  }
  return updated;
}

}  // namespace sylph
