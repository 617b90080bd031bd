#pragma once

#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Shortest path lengths from every vertex to the goal of each agent [cells], each searched as far
/// as it is asked for. Not to be shared between threads before completeAll().
class DistanceTables {
 public:
  /// @param grid, graph  must outlive this object
  DistanceTables(const Grid& grid, const Graph& graph, const Configuration& goals);

  int get(AgentId agent, VertexId vertex) const {
    return fields_[static_cast<std::size_t>(agent)].atIndex(graph_->indexAt(vertex));
  }

  /// Sum over the agents of the distance to their goals: a lower bound of the cost to go.
  long sum(const Vertices& configuration) const;

  void completeAll() const;

  /// The same distances by cell, per agent.
  const std::vector<DistanceField>& fields() const { return fields_; }

 private:
  const Graph* graph_;
  std::vector<DistanceField> fields_;
};

}  // namespace sylph
