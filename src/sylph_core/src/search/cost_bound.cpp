#include "sylph_core/search/cost_bound.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "sylph_core/search/group_delay.hpp"
#include "sylph_core/search/pair_costs.hpp"

namespace sylph {
namespace {

bool has(std::uint32_t agents, int agent) {
  return (agents >> agent & 1U) != 0U;
}

/// Whether delays of single agents with a given sum meet those of the groups, by depth-first
/// search: some agent of the group that lacks most is later by one.
class DelayAssignment {
 public:
  DelayAssignment(const std::vector<DelayOfAgents>& groups, int agents)
      : groups_(&groups), delays_(static_cast<std::size_t>(agents), 0) {}

  enum class Answer { Yes, No, Unknown };

  Answer isPossible(int sum) {
    left_ = kMostNodes;
    const bool is_found = search(sum, 0);
    return left_ <= 0 ? Answer::Unknown : is_found ? Answer::Yes : Answer::No;
  }

 private:
  static constexpr long kMostNodes = 100'000;

  int lack(const DelayOfAgents& group) const {
    int delay = 0;
    for (std::size_t agent = 0; agent < delays_.size(); ++agent) {
      delay += has(group.agents, static_cast<int>(agent)) ? delays_[agent] : 0;
    }
    return group.delay - delay;
  }

  /// @param settled  agents whose delay does not grow any more
  bool search(int sum, std::uint32_t settled) {
    if (--left_ <= 0) {
      return false;
    }
    const DelayOfAgents* worst = nullptr;
    int most = 0;
    for (const DelayOfAgents& group : *groups_) {
      const int lacking = lack(group);
      if (lacking > most) {
        most = lacking;
        worst = &group;
      }
    }
    if (worst == nullptr) {
      return true;
    }
    if (most > sum) {
      return false;
    }
    for (std::size_t agent = 0; agent < delays_.size(); ++agent) {
      const std::uint32_t bit = 1U << agent;
      if ((worst->agents & bit & ~settled) == 0) {
        continue;
      }
      ++delays_[agent];
      const bool is_found = search(sum - 1, settled);
      --delays_[agent];
      if (is_found) {
        return true;
      }
      settled |= bit;
    }
    return false;
  }

  const std::vector<DelayOfAgents>* groups_;
  std::vector<int> delays_;
  long left_ = 0;
};

/// Of the groups within some agents.
int leastDelayWithin(const std::vector<DelayOfAgents>& groups, std::uint32_t agents, int count) {
  std::vector<DelayOfAgents> within;
  for (const DelayOfAgents& group : groups) {
    if ((group.agents & ~agents) == 0) {
      within.push_back(group);
    }
  }
  return leastTeamDelay(within, count);
}

std::vector<AgentId> membersOf(std::uint32_t agents, int count) {
  std::vector<AgentId> members;
  for (AgentId agent = 0; agent < count; ++agent) {
    if (has(agents, agent)) {
      members.push_back(agent);
    }
  }
  return members;
}

}  // namespace

int leastTeamDelay(const std::vector<DelayOfAgents>& groups, int agents) {
  int delay = 0;
  for (const DelayOfAgents& group : groups) {
    delay = std::max(delay, group.delay);
  }
  DelayAssignment assignment(groups, agents);
  while (assignment.isPossible(delay) == DelayAssignment::Answer::No) {
    ++delay;
  }
  return delay;
}

long provedSumOfCosts(const SearchProblem& problem, long enough, const Deadline& deadline,
                      const ImprovementSettings& settings) {
  const double group_s = settings.proof_share_of_group * deadline.remaining();
  const long distances = problem.distances.sum(problem.starts);
  const int agents = problem.agentCount();
  if (agents > settings.most_agents_of_proof || distances >= enough) {
    return distances;
  }
  const std::optional<PairCosts> costs = PairCosts::compute(problem, deadline);
  if (!costs) {
    return distances;
  }
  const int most = static_cast<int>(enough - distances);
  std::vector<DelayOfAgents> groups;
  for (AgentId b = 0; b < agents; ++b) {
    for (AgentId a = 0; a < b; ++a) {
      const int delay = costs->delay(a, {problem.starts[static_cast<std::size_t>(a)], false}, b,
                                     {problem.starts[static_cast<std::size_t>(b)], false});
      if (delay > 0) {
        groups.push_back({1U << a | 1U << b, std::min(delay, most)});
      }
    }
  }
  int proved = leastTeamDelay(groups, agents);
  for (std::size_t size = 3; size <= GroupDelay::kMostAgents; ++size) {
    for (std::uint32_t members = 0; members < 1U << agents; ++members) {
      const std::vector<AgentId> group = membersOf(members, agents);
      if (group.size() != size) {
        continue;
      }
      if (proved >= most || deadline.isOver()) {
        return std::min(distances + proved, enough);
      }
      const int known = leastDelayWithin(groups, members, agents);
      GroupDelay delay(problem, *costs, group, known);
      delay.prove(most, deadline.within(group_s));
      if (delay.delay() > known) {
        groups.push_back({members, delay.delay()});
      }
    }
    proved = std::max(proved, leastTeamDelay(groups, agents));
  }
  return std::min(distances + proved, enough);
}

}  // namespace sylph
