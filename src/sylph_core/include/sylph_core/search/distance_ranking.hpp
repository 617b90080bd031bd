#pragma once

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/distance_tables.hpp"
#include "sylph_core/search/guide_paths.hpp"
#include "sylph_core/search/move_ranking.hpp"

namespace sylph {

/// Prefers the vertex that an agent's guide path leads to, then those nearer to its goal; equals
/// are in random order.
class DistanceRanking : public MoveRanking {
 public:
  /// @param distances, guides, rng  must outlive this object
  DistanceRanking(const DistanceTables& distances, const GuidePaths& guides, Rng& rng);

  void observe(const Vertices& configuration) override;
  void rank(AgentId agent, VertexId at, Moves& moves) override;

 private:
  const DistanceTables* distances_;
  const GuidePaths* guides_;
  Rng* rng_;
};

}  // namespace sylph
