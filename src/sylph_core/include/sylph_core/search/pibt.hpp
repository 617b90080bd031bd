#pragma once

#include <vector>

#include "sylph_core/search/distance_tables.hpp"
#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/move_ranking.hpp"

namespace sylph {

/// Priority inheritance with backtracking: one collision-free joint step of all agents.
///
/// Okumura et al. 2022, "Priority Inheritance with Backtracking for Iterative Multi-agent Path
/// Finding"; the swap rule is that of Okumura 2023, "Improving LaCAM for Scalable Eventually
/// Optimal Multi-Agent Pathfinding". Without rotations an agent may not make the move that would
/// close a ring of moving agents. Each agent can still fall back on staying, so that a step without
/// constraints always succeeds; only the guarantee that the first agent in order gets its first
/// choice is lost where that choice lies in a full ring.
class Pibt {
 public:
  /// @param graph, distances  must outlive this object
  Pibt(const Graph& graph, const Vertices& goals, const DistanceTables& distances,
       MotionModel motion);

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
  bool closesRing(AgentId agent, VertexId target) const;
  void pull(AgentId agent, AgentId into_place_of);

  AgentId findSwapPartner(AgentId agent, const Moves& moves) const;
  bool haveToSwap(AgentId pusher, AgentId puller, VertexId from, VertexId to) const;
  int waysOn(VertexId at, VertexId back, VertexId& onward) const;

  const Graph* graph_;
  Vertices goals_;
  const DistanceTables* distances_;
  MotionModel motion_;
  std::vector<AgentId> now_;   // who is on a vertex
  std::vector<AgentId> next_;  // who will be on it
  const Vertices* from_ = nullptr;
  Vertices* to_ = nullptr;
  MoveRanking* ranking_ = nullptr;
};

}  // namespace sylph
