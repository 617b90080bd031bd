#include "sylph_core/search/group_delay.hpp"

#include <algorithm>
#include <utility>

namespace sylph {
namespace {

/// About 100 MB.
constexpr std::size_t kMostConfigurations = 2'000'000;

/// The clock is asked once in so many configurations.
constexpr std::size_t kConfigurationsPerQuestion = 64;

}  // namespace

GroupDelay::GroupDelay(const SearchProblem& problem, const PairCosts& costs,
                       std::vector<AgentId> agents, int known_delay)
    : problem_(&problem), costs_(&costs), agents_(std::move(agents)), delay_(known_delay) {}

bool GroupDelay::prove(int most_delay, const Deadline& deadline) {
  Places starts{};
  int distances = 0;
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    starts[agent] = {problem_->starts[static_cast<std::size_t>(agents_[agent])], false};
    distances += distance(agent, starts[agent].vertex);
  }
  delay_ = std::max(delay_, costToCome(starts) - distances);
  deadline_ = &deadline;
  while (delay_ < most_delay) {
    limit_ = distances + delay_;
    least_spent_.clear();
    const Found found = search(starts, 0);
    if (found != Found::Nothing) {
      return found == Found::Goals;
    }
    ++delay_;
  }
  return true;
}

GroupDelay::Found GroupDelay::search(const Places& from, int spent) {
  Key key{};
  bool have_all_arrived = true;
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    const auto place = static_cast<std::uint64_t>(from[agent].vertex) << 1U |
                       static_cast<std::uint64_t>(from[agent].has_arrived);
    key[agent / 4] |= place << (16U * (agent % 4));
    have_all_arrived = have_all_arrived && from[agent].has_arrived;
  }
  if (have_all_arrived) {
    return Found::Goals;
  }
  const auto [known, is_new] = least_spent_.emplace(key, spent);
  if (!is_new && known->second <= spent) {
    return Found::Nothing;
  }
  known->second = spent;
  if (least_spent_.size() > kMostConfigurations ||
      (is_new && least_spent_.size() % kConfigurationsPerQuestion == 0 && deadline_->isOver())) {
    return Found::OutOfResources;
  }
  int to_come_alone = 0;
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    to_come_alone += from[agent].has_arrived ? 0 : distance(agent, from[agent].vertex);
  }
  std::vector<Step> steps;
  Places to = from;
  addSteps(from, to, 0, spent, to_come_alone, steps);
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.to_come < b.to_come; });
  for (const Step& step : steps) {
    const Found found = search(step.to, step.spent);
    if (found != Found::Nothing) {
      return found;
    }
  }
  return Found::Nothing;
}

/// @param agent          those before it have chosen, into `to`
/// @param to_come_alone  the distances of those that have chosen from there, of the others from
///                       where they are
void GroupDelay::addSteps(const Places& from, Places& to, std::size_t agent, int spent,
                          int to_come_alone, std::vector<Step>& steps) const {
  if (spent + to_come_alone > limit_) {
    return;
  }
  if (agent == agents_.size()) {
    const int to_come = costToCome(to);
    if (spent + to_come <= limit_ && !rotates(from, to)) {
      steps.push_back({to, spent, to_come});
    }
    return;
  }
  const AgentPlace& here = from[agent];
  const int distance_here = here.has_arrived ? 0 : distance(agent, here.vertex);
  const auto go = [&](VertexId vertex, bool has_arrived) {
    if (isFree(from, to, agent, vertex)) {
      to[agent] = {vertex, has_arrived};
      addSteps(from, to, agent + 1, spent + (has_arrived ? 0 : 1),
               to_come_alone - distance_here + (has_arrived ? 0 : distance(agent, vertex)), steps);
    }
  };
  const bool is_on_goal = here.vertex == problem_->goals[static_cast<std::size_t>(agents_[agent])];
  if (is_on_goal) {
    go(here.vertex, true);
  }
  if (!here.has_arrived) {
    for (const VertexId neighbor : problem_->graph.neighbors(here.vertex)) {
      go(neighbor, false);
    }
    go(here.vertex, false);
  }
}

/// Whether an agent may go to a cell beside those that have chosen before it.
bool GroupDelay::isFree(const Places& from, const Places& to, std::size_t agent, VertexId vertex) {
  for (std::size_t other = 0; other < agent; ++other) {
    const bool is_swap = to[other].vertex == from[agent].vertex && from[other].vertex == vertex;
    if (to[other].vertex == vertex || is_swap) {
      return false;
    }
  }
  return true;
}

/// Whether three or more agents rotate and may not.
bool GroupDelay::rotates(const Places& from, const Places& to) const {
  if (problem_->motion.rotations) {
    return false;
  }
  const auto ownerOf = [&](VertexId vertex) {
    std::size_t agent = 0;
    while (agent < agents_.size() && from[agent].vertex != vertex) {
      ++agent;
    }
    return agent;
  };
  for (std::size_t first = 0; first < agents_.size(); ++first) {
    std::size_t agent = first;
    for (std::size_t steps = 0; steps < agents_.size(); ++steps) {
      if (to[agent].vertex == from[agent].vertex) {
        break;
      }
      agent = ownerOf(to[agent].vertex);
      if (agent == first) {
        return true;
      }
      if (agent == agents_.size()) {
        break;
      }
    }
  }
  return false;
}

/// At least: the distances, and what pairs cost besides that have no agent in common, or three
/// pairs of three agents, in which each agent's delay counts twice.
int GroupDelay::costToCome(const Places& places) const {
  int distances = 0;
  std::array<std::array<int, kMostAgents>, kMostAgents> delays{};
  const std::size_t count = agents_.size();
  int most_of_three = 0;
  for (std::size_t a = 0; a < count; ++a) {
    distances += places[a].has_arrived ? 0 : distance(a, places[a].vertex);
    for (std::size_t b = 0; b < a; ++b) {
      delays[a][b] = costs_->delay(agents_[a], places[a], agents_[b], places[b]);
      if (delays[a][b] == PairCosts::kNoWay) {
        return PairCosts::kNoWay;
      }
      for (std::size_t c = 0; c < b; ++c) {
        most_of_three =
            std::max(most_of_three, (delays[a][b] + delays[b][c] + delays[a][c] + 1) / 2);
      }
    }
  }
  // Heaviest matching of the first agents, by which of them are in it.
  std::array<int, std::size_t{1} << kMostAgents> most_of_pairs{};
  for (std::size_t agents = 1; agents < std::size_t{1} << count; ++agents) {
    std::size_t last = count - 1;
    while ((agents >> last & 1U) == 0) {
      --last;
    }
    const std::size_t others = agents & ~(std::size_t{1} << last);
    int most = most_of_pairs[others];
    for (std::size_t other = 0; other < last; ++other) {
      if ((others >> other & 1U) != 0) {
        most = std::max(most,
                        delays[last][other] + most_of_pairs[others & ~(std::size_t{1} << other)]);
      }
    }
    most_of_pairs[agents] = most;
  }
  return distances + std::max(most_of_three, most_of_pairs[(std::size_t{1} << count) - 1]);
}

std::size_t GroupDelay::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = 0;
  for (const std::uint64_t part : key) {
    hash = (hash ^ part) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 32U;
  }
  return hash;
}

}  // namespace sylph
