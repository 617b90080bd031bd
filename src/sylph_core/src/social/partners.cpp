#include "sylph_core/social/partners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace sylph {
namespace {

constexpr double kOverlapDecay = 0.95;
// Overlaps are added up in whole numbers: the order of summing then changes nothing, so that equal
// overlaps are equal and the lowest index decides.
constexpr double kWeightUnits = 1099511627776.0;  // 2^40 for a weight of 1
constexpr int kNoCrossing = -1;

/// gamma^index, never zero: far crossings are crossings too.
std::int64_t weightOf(std::size_t index) {
  static const std::vector<std::int64_t> kWeights = [] {
    std::vector<std::int64_t> weights;
    for (double weight = kWeightUnits; weight > 1.0; weight *= kOverlapDecay) {
      weights.push_back(std::llround(weight));
    }
    return weights;
  }();
  return index < kWeights.size() ? kWeights[index] : 1;
}

std::size_t toIndex(AgentId agent) {
  return static_cast<std::size_t>(agent);
}

}  // namespace

Partners::Partners(const Grid& grid, DistanceToGoal distance, const Configuration& cells)
    : grid_(&grid),
      distance_(std::move(distance)),
      paths_(cells.size()),
      visits_(static_cast<std::size_t>(grid.size())),
      fixed_(cells.size()),
      crossing_(cells.size(), kNoCrossing),
      sums_(cells.size(), 0) {
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    layPath(static_cast<AgentId>(agent), cells[agent]);
  }
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    fixed_[agent] = static_cast<AgentId>(agent);
    updateFixed(static_cast<AgentId>(agent));
  }
}

void Partners::requireCount(std::size_t count) const {
  if (count != paths_.size()) {
    throw std::invalid_argument(std::to_string(count) + " agents instead of " +
                                std::to_string(paths_.size()));
  }
}

void Partners::update(const Configuration& cells, const std::vector<AgentId>& before) {
  requireCount(before.size());
  for (std::size_t agent = 0; agent < before.size(); ++agent) {
    // A search jumps between configurations: the partners are those of the way that led here, not
    // of the one looked at last.
    if (fixed_[agent] != before[agent]) {
      fixed_[agent] = before[agent];
      crossing_[agent] = kNoCrossing;
    }
  }
  update(cells);
}

void Partners::update(const Configuration& cells) {
  requireCount(cells.size());
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    Path& path = paths_[agent];
    const int cell = grid_->indexOf(cells[agent]);
    if (cell == path.cells[path.next]) {
      continue;
    }
    // Most agents go on along their path, so that it need not be laid anew.
    if (path.next + 1 < path.cells.size() && cell == path.cells[path.next + 1]) {
      removeVisit(static_cast<AgentId>(agent), path.cells[path.next]);
      ++path.next;
    } else {
      takeUpPath(static_cast<AgentId>(agent));
      layPath(static_cast<AgentId>(agent), cells[agent]);
    }
  }
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    updateFixed(static_cast<AgentId>(agent));
  }
}

void Partners::layPath(AgentId agent, const Cell& start) {
  Path& path = paths_[toIndex(agent)];
  path.cells.clear();
  path.next = 0;
  Cell cell = start;
  for (int distance = distance_(agent, cell);; --distance) {
    Action flow = Action::Stay;
    for (const Action action : kActions) {
      const Cell reached = neighbor(cell, action);
      if (grid_->isFree(reached) && distance_(agent, reached) == distance - 1) {
        flow = action;
        break;
      }
    }
    const int index = grid_->indexOf(cell);
    visits_[static_cast<std::size_t>(index)].push_back({agent, flow, path.cells.size()});
    path.cells.push_back(index);
    if (flow == Action::Stay) {
      return;
    }
    cell = neighbor(cell, flow);
  }
}

void Partners::takeUpPath(AgentId agent) {
  const Path& path = paths_[toIndex(agent)];
  for (std::size_t step = path.next; step < path.cells.size(); ++step) {
    removeVisit(agent, path.cells[step]);
  }
}

void Partners::removeVisit(AgentId agent, int cell) {
  std::vector<Visit>& visits = visits_[static_cast<std::size_t>(cell)];
  const auto visit = std::find_if(visits.begin(), visits.end(),
                                  [&](const Visit& other) { return other.agent == agent; });
  *visit = visits.back();
  visits.pop_back();
}

void Partners::updateFixed(AgentId agent) {
  AgentId& partner = fixed_[toIndex(agent)];
  int& crossing = crossing_[toIndex(agent)];
  if (crossing != kNoCrossing && isCrossing(agent, partner, crossing)) {
    return;
  }
  crossing = findCrossing(agent, partner).value_or(kNoCrossing);
  if (crossing == kNoCrossing) {
    partner = temporary(agent);
    crossing = findCrossing(agent, partner).value_or(kNoCrossing);
  }
}

template <typename Callback>
void Partners::forEachCrossing(AgentId agent, Callback callback) const {
  const Path& path = paths_[toIndex(agent)];
  for (std::size_t step = path.next; step < path.cells.size(); ++step) {
    const std::vector<Visit>& visits = visits_[static_cast<std::size_t>(path.cells[step])];
    if (visits.size() == 1) {
      continue;
    }
    // Alg. 1: the same cell, but not the same way on.
    const auto own = std::find_if(visits.begin(), visits.end(),
                                  [&](const Visit& visit) { return visit.agent == agent; });
    for (const Visit& visit : visits) {
      if (visit.flow != own->flow) {
        const std::size_t index = visit.step - paths_[toIndex(visit.agent)].next;
        callback(visit.agent, weightOf(step - path.next) + weightOf(index));
      }
    }
  }
}

bool Partners::isCrossing(AgentId agent, AgentId other, int cell) const {
  std::optional<Action> own;
  std::optional<Action> others;
  for (const Visit& visit : visits_[static_cast<std::size_t>(cell)]) {
    if (visit.agent == agent) {
      own = visit.flow;
    } else if (visit.agent == other) {
      others = visit.flow;
    }
  }
  return own && others && *own != *others;
}

std::optional<int> Partners::findCrossing(AgentId agent, AgentId other) const {
  if (agent == other) {
    return std::nullopt;
  }
  // From the goal backwards: the last crossing is the one that lasts longest.
  const Path& path = paths_[toIndex(agent)];
  for (std::size_t step = path.cells.size(); step > path.next; --step) {
    if (isCrossing(agent, other, path.cells[step - 1])) {
      return path.cells[step - 1];
    }
  }
  return std::nullopt;
}

AgentId Partners::temporary(AgentId agent) const {
  std::vector<AgentId> crossed;
  forEachCrossing(agent, [&](AgentId other, std::int64_t weight) {
    if (sums_[toIndex(other)] == 0) {
      crossed.push_back(other);
    }
    sums_[toIndex(other)] += weight;
  });
  AgentId best = agent;
  std::int64_t best_sum = 0;
  for (const AgentId other : crossed) {
    const std::int64_t sum = std::exchange(sums_[toIndex(other)], 0);
    if (sum > best_sum || (sum == best_sum && other < best)) {
      best = other;
      best_sum = sum;
    }
  }
  return best;
}

double Partners::overlap(AgentId agent, AgentId other) const {
  std::int64_t sum = 0;
  forEachCrossing(
      agent, [&](AgentId crossed, std::int64_t weight) { sum += crossed == other ? weight : 0; });
  return static_cast<double>(sum) / kWeightUnits;
}

std::vector<SocialState> partnersAlongPlan(const Grid& grid, const DistanceToGoal& distance,
                                           const Plan& plan, const std::function<bool()>& isOver) {
  std::vector<SocialState> states;
  if (plan.size() < 2 || isOver()) {
    return states;
  }
  const std::vector<float> unknown_svo(plan.front().size(),
                                       std::numeric_limits<float>::quiet_NaN());
  Partners partners(grid, distance, plan.front());
  states.push_back({partners.fixed(), unknown_svo});
  for (std::size_t step = 1; step + 1 < plan.size() && !isOver(); ++step) {
    partners.update(plan[step]);
    states.push_back({partners.fixed(), unknown_svo});
  }
  return states;
}

}  // namespace sylph
