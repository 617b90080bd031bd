#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/social/social_state.hpp"

namespace sylph {

/// Length of the shortest path of an agent from a free cell to its goal [cells].
using DistanceToGoal = std::function<int(AgentId, const Cell&)>;

/// The partner of every agent, from timestep to timestep.
/// He et al. 2024 (arXiv:2408.03063), Alg. 1 and 2.
///
/// Each agent's shortest path to its goal has a flow: the direction in which it leaves each of its
/// cells; none at the goal, which differs from every direction. The overlap of agents i and j sums
/// gamma^index_i + gamma^index_j over the cells on both paths whose flows differ, with gamma = 0.95
/// and the index of the cell on each path. The temporary partner (Alg. 1) is the agent with the
/// largest overlap, the lowest index of equals, oneself if all are zero. The fixed partner (Alg. 2)
/// is kept until the overlap with it is zero; then the temporary one takes its place.
///
/// Shortest paths are walked downhill as by shortestPath(), first move of equals in the order
/// North, East, South, West. So who follows its path keeps the rest of it, and a timestep costs
/// time linear in the length of the paths that change and in the overlaps that are asked for.
class Partners {
 public:
  /// The first timestep: every fixed partner is the temporary one.
  /// @param grid   must outlive this object, as must whatever `distance` refers to
  /// @param cells  distinct free cells from which the goals can be reached
  Partners(const Grid& grid, DistanceToGoal distance, const Configuration& cells);

  /// The next timestep.
  /// @throws std::invalid_argument if the number of agents is another
  void update(const Configuration& cells);

  /// Another timestep: that after one in which the fixed partners were those of `before`. Whoever
  /// is its own partner there takes the temporary one.
  /// @throws std::invalid_argument if the number of agents is another
  void update(const Configuration& cells, const std::vector<AgentId>& before);

  /// Fixed partner of each agent.
  const std::vector<AgentId>& fixed() const { return fixed_; }
  /// Temporary partner of one agent.
  AgentId temporary(AgentId agent) const;
  /// Overlap of two agents, symmetric, 0 with oneself.
  double overlap(AgentId agent, AgentId other) const;

 private:
  struct Visit {
    AgentId agent;
    Action flow;       // Stay: none
    std::size_t step;  // of the path as it was found
  };
  struct Path {
    std::vector<int> cells;  // grid indices, as found; those before `next` are left behind
    std::size_t next = 0;
  };

  void requireCount(std::size_t count) const;
  void layPath(AgentId agent, const Cell& start);
  void takeUpPath(AgentId agent);
  void removeVisit(AgentId agent, int cell);
  void updateFixed(AgentId agent);
  /// Calls back with each visit of another agent that flows differently, and with its weight.
  template <typename Callback>
  void forEachCrossing(AgentId agent, Callback callback) const;
  bool isCrossing(AgentId agent, AgentId other, int cell) const;
  std::optional<int> findCrossing(AgentId agent, AgentId other) const;

  const Grid* grid_;
  DistanceToGoal distance_;
  std::vector<Path> paths_;                 // per agent
  std::vector<std::vector<Visit>> visits_;  // per cell
  std::vector<AgentId> fixed_;
  std::vector<int> crossing_;  // per agent: a cell where it crosses its fixed partner, if any
  mutable std::vector<std::int64_t> sums_;  // per agent, zero between calls
};

/// The partners at each joint action of a plan, for planners that do not choose them themselves.
/// SVOs are unknown (NaN).
/// @param isOver  asked before each timestep; whether to break off
/// @return one state per joint action, plan.size() - 1, unless broken off
std::vector<SocialState> partnersAlongPlan(
    const Grid& grid, const DistanceToGoal& distance, const Plan& plan,
    const std::function<bool()>& isOver = [] { return false; });

}  // namespace sylph
