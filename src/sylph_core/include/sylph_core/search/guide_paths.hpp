#pragma once

#include <utility>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/distance_tables.hpp"
#include "sylph_core/search/graph.hpp"

namespace sylph {

/// A path for each agent, planned so that together they spread over the map; a hint, not a promise.
///
/// "Space utilization optimization" of Okumura 2024, "Engineering LaCAM*: Towards Real-Time,
/// Large-Scale, and Near-Optimal Multi-Agent Pathfinding".
class GuidePaths {
 public:
  /// No hints.
  GuidePaths() = default;

  /// Plans the agents one after the other, again and again while that helps, each along the path
  /// with the fewest collisions with the others among those that are at most `detour` longer than
  /// its shortest one.
  /// @param detour  [cells], >= 0
  static GuidePaths spreadOut(const Graph& graph, const Vertices& starts, const Vertices& goals,
                              const DistanceTables& distances, int detour, const Deadline& deadline,
                              Rng& rng);

  /// Where an agent's guide path leads from a vertex, kNoVertex where it does not pass.
  VertexId next(AgentId agent, VertexId at) const;

 private:
  // Per agent (vertex, next vertex), sorted by vertex.
  std::vector<std::vector<std::pair<VertexId, VertexId>>> next_;
};

}  // namespace sylph
