#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Shortest path lengths from every vertex to the goal of each agent [cells].
///
/// An agent's table is computed by breadth-first search when it is first asked for, so that agents
/// which a search never looks at cost nothing. Not to be shared between threads before
/// computeAll().
class DistanceTables {
 public:
  static constexpr int kUnreachable = std::numeric_limits<std::int32_t>::max() / 2;

  /// @param graph must outlive this object
  DistanceTables(const Graph& graph, const Vertices& goals);

  int get(AgentId agent, VertexId vertex) const {
    const std::vector<std::int32_t>& table = tables_[static_cast<std::size_t>(agent)];
    if (table.empty()) {
      compute(agent);
    }
    return table[static_cast<std::size_t>(vertex)];
  }

  /// Sum over the agents of the distance to their goals: a lower bound of the cost to go.
  long sum(const Vertices& configuration) const;

  void computeAll() const;

 private:
  void compute(AgentId agent) const;

  const Graph* graph_;
  Vertices goals_;
  mutable std::vector<std::vector<std::int32_t>> tables_;
};

}  // namespace sylph
