#include "joint_search.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/components.hpp"
#include "sylph_core/mapf/check_plan.hpp"

namespace sylph {
namespace {

int drawInt(Rng& rng, int low, int high) {
  return low + static_cast<int>(drawIndex(rng, static_cast<std::size_t>(high - low + 1)));
}

bool isLegalStep(const Configuration& from, const Configuration& to, bool rotations) {
  for (std::size_t a = 0; a < from.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (to[a] == to[b] || (to[a] == from[b] && to[b] == from[a])) {
        return false;
      }
    }
  }
  return rotations || findRotations(from, to).empty();
}

void forEachStep(const Grid& grid, const Configuration& from, Configuration& to,
                 const std::function<void()>& visit) {
  const std::size_t agent = to.size();
  if (agent == from.size()) {
    visit();
    return;
  }
  for (const Action action : kActions) {
    if (grid.isFree(neighbor(from[agent], action))) {
      to.push_back(neighbor(from[agent], action));
      forEachStep(grid, from, to, visit);
      to.pop_back();
    }
  }
}

long stepCost(const Instance& instance, const Configuration& from, const Configuration& to) {
  long cost = 0;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    const Cell& goal = instance.goals[agent];
    cost += from[agent] == goal && to[agent] == goal ? 0 : 1;
  }
  return cost;
}

/// @param resting  agents, as bits, that stay where they are for good and cost nothing
/// @return nothing if one of these would move
std::optional<long> costWhileResting(const Configuration& from, const Configuration& to,
                                     unsigned resting) {
  long cost = 0;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    const bool is_resting = (resting >> agent & 1U) != 0;
    if (is_resting && to[agent] != from[agent]) {
      return std::nullopt;
    }
    cost += is_resting ? 0 : 1;
  }
  return cost;
}

}  // namespace

std::optional<long> leastCostByJointSearch(const Instance& instance) {
  using Entry = std::pair<long, Configuration>;
  std::map<Configuration, long> costs = {{instance.starts, 0}};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(0, instance.starts);
  while (!open.empty()) {
    const auto [cost, from] = open.top();
    open.pop();
    if (from == instance.goals) {
      return cost;
    }
    if (cost > costs.at(from)) {
      continue;
    }
    Configuration to;
    const auto relax = [&, cost_so_far = cost, &origin = from] {
      const long new_cost = cost_so_far + stepCost(instance, origin, to);
      const auto known = costs.find(to);
      if ((known == costs.end() || new_cost < known->second) &&
          isLegalStep(origin, to, instance.motion.rotations)) {
        costs[to] = new_cost;
        open.emplace(new_cost, to);
      }
    };
    forEachStep(instance.grid, from, to, relax);
  }
  return std::nullopt;
}

std::optional<long> leastSumOfCostsByJointSearch(const Instance& instance) {
  // Agents, as bits, that stay where they are for good.
  using State = std::pair<Configuration, unsigned>;
  using Entry = std::pair<long, State>;
  const std::size_t agents = instance.starts.size();
  std::map<State, long> costs;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto relax = [&](const State& state, long cost) {
    const auto known = costs.find(state);
    if (known == costs.end() || cost < known->second) {
      costs[state] = cost;
      open.emplace(cost, state);
    }
  };
  relax({instance.starts, 0U}, 0);
  while (!open.empty()) {
    const auto [cost, state] = open.top();
    open.pop();
    const auto& [from, resting] = state;
    if (resting == (1U << agents) - 1U) {
      return cost;
    }
    if (cost > costs.at(state)) {
      continue;
    }
    for (std::size_t agent = 0; agent < agents; ++agent) {
      if (from[agent] == instance.goals[agent]) {
        relax({from, resting | 1U << agent}, cost);
      }
    }
    Configuration to;
    const auto step = [&, cost_so_far = cost, &origin = from, bits = resting] {
      const std::optional<long> step_cost = costWhileResting(origin, to, bits);
      if (step_cost && isLegalStep(origin, to, instance.motion.rotations)) {
        relax({to, bits}, cost_so_far + *step_cost);
      }
    };
    forEachStep(instance.grid, from, to, step);
  }
  return std::nullopt;
}

Instance crowdedInstance(int max_agents, bool rotations, Rng& rng) {
  while (true) {
    Instance instance{Grid(drawInt(rng, 1, 3), drawInt(rng, 2, 4)), {}, {}, {rotations}};
    for (int index = 0; index < instance.grid.size(); ++index) {
      instance.grid.setObstacle(instance.grid.cellAt(index), drawInt(rng, 0, 3) == 0);
    }
    const Components components = connectedComponents(instance.grid);
    if (components.cells.empty() || components.cells.front().size() < 2) {
      continue;
    }
    Configuration cells = components.cells.front();
    const int agents = drawInt(rng, 1, std::min(max_agents, static_cast<int>(cells.size())));
    shuffle(cells, rng);
    instance.starts.assign(cells.begin(), cells.begin() + agents);
    shuffle(cells, rng);
    instance.goals.assign(cells.begin(), cells.begin() + agents);
    return instance;
  }
}

}  // namespace sylph
