#include "sylph_core/search/distance_ranking.hpp"

#include <cstdint>

namespace sylph {

DistanceRanking::DistanceRanking(const DistanceTables& distances, Rng& rng)
    : distances_(&distances), rng_(&rng) {}

void DistanceRanking::rank(AgentId agent, VertexId /*at*/, const Occupants& /*occupied_now*/,
                           Moves& moves) {
  sortMoves(moves, [&](VertexId target) {
    const std::int64_t distance = distances_->get(agent, target);
    // Chance in the low half settles what is equal in the high one.
    return distance * (std::int64_t{1} << 32) + static_cast<std::int64_t>((*rng_)());
  });
}

}  // namespace sylph
