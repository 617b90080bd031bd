#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// Where an agent is, and whether it stays there for good: on its goal, at no further cost.
struct AgentPlace {
  VertexId vertex;
  bool has_arrived;
};

/// How much later two agents arrive, added up, than each would alone: exact if nobody else were on
/// the map, and so at most what it is in any plan. From every pair of cells, for maps and teams of
/// a lab's size.
class PairCosts {
 public:
  /// More than any delay: the two block each other for ever.
  static constexpr int kNoWay = 1 << 28;

  /// By Dijkstra's algorithm over the pairs of cells, backwards from the goals.
  /// @param problem  must outlive the result
  /// @return none if the tables would take too much memory, or the time was over before
  static std::optional<PairCosts> compute(const SearchProblem& problem, const Deadline& deadline);

  /// @param a, b  two different agents, each in a cell from which its goal can be reached
  /// @return [timesteps], >= 0, kNoWay
  int delay(AgentId a, const AgentPlace& from_a, AgentId b, const AgentPlace& from_b) const;

 private:
  explicit PairCosts(const SearchProblem& problem);

  // False if the time was over before.
  bool computeBesideArrived(AgentId arrived, AgentId moving, const Deadline& deadline);
  bool computePair(AgentId a, AgentId b, const Deadline& deadline);
  std::vector<int>& besideArrived(AgentId arrived, AgentId moving) {
    return beside_arrived_[static_cast<std::size_t>(arrived * problem_->agentCount() + moving)];
  }
  const std::vector<int>& besideArrived(AgentId arrived, AgentId moving) const {
    return beside_arrived_[static_cast<std::size_t>(arrived * problem_->agentCount() + moving)];
  }

  const SearchProblem* problem_;
  // Costs to go, kNoWay where there is none.
  std::vector<std::vector<int>> beside_arrived_;  // [arrived * agents + moving][vertex of moving]
  std::vector<std::vector<int>> both_;  // [a * agents + b][vertex of a * size + that of b]
};

}  // namespace sylph
