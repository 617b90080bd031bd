#pragma once

#include <vector>

#include "sylph_core/search/move_ranking.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// Priority inheritance with backtracking: one collision-free joint step of all agents.
///
/// Okumura et al. 2022, "Priority Inheritance with Backtracking for Iterative Multi-agent Path
/// Finding", Alg. 1, is step(), whose procedure PIBT(a_i, a_j) is choose(); Q_from and Q_to are
/// `from` and `to`. The swap rule is that of Okumura 2023, "Improving LaCAM for Scalable Eventually
/// Optimal Multi-Agent Pathfinding", see swap_rule.hpp. Differs in two ways:
/// agents may be bound to vertices, which is how LaCAM's constraints come in, and without rotations
/// an agent may not make the move that would close a rotation. Each agent can still fall back on
/// staying, so that a step without constraints always succeeds; only the guarantee that the first
/// agent in order gets its first choice is lost where that choice lies in a closed cycle of agents.
class Pibt {
 public:
  /// @param problem  must outlive this object
  explicit Pibt(const SearchProblem& problem);

  /// @param from   where the agents are, all different
  /// @param order  all agents, the one that chooses first at the front
  /// @param to     in: kNoVertex, or the vertex that an agent is bound to reach;
  ///               out: where the agents go
  /// @return false if no step was found that keeps to the bound agents' vertices (`to` is then of
  /// no use). It may exist all the same: PIBT does not search.
  bool step(const Vertices& from, const std::vector<AgentId>& order, MoveRanking& ranking,
            Vertices& to);

 private:
  bool bindAgents(const Vertices& from, const Vertices& to);
  bool choose(AgentId agent);
  bool closesRotation(AgentId agent, VertexId target) const;
  void pull(AgentId agent, AgentId into_place_of);

  AgentId findSwapPartner(AgentId agent, const Moves& moves) const;
  bool haveToSwap(AgentId pusher, AgentId puller, VertexId from, VertexId to) const;
  int countWaysOn(VertexId at, VertexId back, VertexId& onward) const;

  const Graph* graph_;
  const Vertices* goals_;
  const DistanceTables* distances_;
  MotionModel motion_;
  Occupants occupied_now_;
  Occupants occupied_next_;  // by agents whose move is settled, until one of them backtracks
  const Vertices* from_ = nullptr;
  Vertices* to_ = nullptr;
  MoveRanking* ranking_ = nullptr;
};

}  // namespace sylph
