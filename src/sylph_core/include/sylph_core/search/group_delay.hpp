#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/pair_costs.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// How much later a few agents arrive, added up, than each would alone, if nobody else were
/// on the map.
///
/// Depth-first search over their joint steps with a limit of cost that rises by one as often as
/// nothing is found (IDA*), led by what pairs of them cost; configurations are remembered.
class GroupDelay {
 public:
  static constexpr std::size_t kMostAgents = 8;

  /// @param problem, costs  must outlive this object
  /// @param agents          at most kMostAgents, distinct
  /// @param known_delay     proved by other means [timesteps]
  GroupDelay(const SearchProblem& problem, const PairCosts& costs, std::vector<AgentId> agents,
             int known_delay);

  /// Raises delay() until it is exact.
  /// @param most_delay  beyond this nobody asks
  /// @return false if the time or the memory did not suffice; what was proved until then counts
  bool prove(int most_delay, const Deadline& deadline);

  /// No plan has a smaller one [timesteps].
  int delay() const { return delay_; }
  const std::vector<AgentId>& agents() const { return agents_; }

 private:
  using Places = std::array<AgentPlace, kMostAgents>;

  using Key = std::array<std::uint64_t, kMostAgents / 4>;  // 16 bits an agent
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  enum class Found { Goals, Nothing, OutOfResources };

  struct Step {
    Places to;
    int spent;    ///< cost until there
    int to_come;  ///< at least
  };

  Found search(const Places& from, int spent);
  void addSteps(const Places& from, Places& to, std::size_t agent, int spent, int to_come_alone,
                std::vector<Step>& steps) const;
  static bool isFree(const Places& from, const Places& to, std::size_t agent, VertexId vertex);
  bool rotates(const Places& from, const Places& to) const;
  int costToCome(const Places& places) const;
  int distance(std::size_t agent, VertexId vertex) const {
    return problem_->distances.get(agents_[agent], vertex);
  }

  const SearchProblem* problem_;
  const PairCosts* costs_;
  std::vector<AgentId> agents_;
  int delay_;
  // Of the search under way.
  int limit_ = 0;
  const Deadline* deadline_ = nullptr;
  std::unordered_map<Key, int, KeyHash> least_spent_;  // by configuration
};

}  // namespace sylph
