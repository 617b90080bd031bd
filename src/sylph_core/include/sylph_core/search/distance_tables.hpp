#pragma once

#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Shortest path lengths from every vertex to the goal of each agent [cells], each searched as far
/// as it is asked for. Not to be shared between threads before completeAll().
class DistanceTables {
 public:
  /// @param grid, graph  must outlive this object
  DistanceTables(const Grid& grid, const Graph& graph, const Configuration& goals);

  /// From a vertex to the goal of an agent; DistanceField::kUnreachable if there is no way.
  int get(AgentId agent, VertexId vertex) const {
    return fields_[static_cast<std::size_t>(agent)].atIndex(graph_->indexAt(vertex));
  }

  /// Sum over the agents of the distance to their goals: a lower bound of the cost to go.
  long sum(const Vertices& configuration) const;

  /// Searches as far as a configuration, so that get() has the answers.
  /// @return false if the time was over before
  bool reach(const Vertices& configuration, const Deadline& deadline) const;
  /// Likewise for all vertices.
  bool completeAll(const Deadline& deadline) const;

  /// The same distances by cell, per agent.
  const std::vector<DistanceField>& fields() const { return fields_; }

 private:
  const Graph* graph_;
  std::vector<DistanceField> fields_;
};

}  // namespace sylph
