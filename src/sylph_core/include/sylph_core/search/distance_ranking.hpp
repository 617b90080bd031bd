#pragma once

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/distance_tables.hpp"
#include "sylph_core/search/move_ranking.hpp"

namespace sylph {

/// Prefers vertices nearer to an agent's goal; equals are in random order.
class DistanceRanking : public MoveRanking {
 public:
  /// @param distances, rng  must outlive this object
  DistanceRanking(const DistanceTables& distances, Rng& rng);

  void rank(AgentId agent, VertexId at, const Occupants& occupied_now, Moves& moves) override;

 private:
  const DistanceTables* distances_;
  Rng* rng_;
};

}  // namespace sylph
