#include "sylph_core/search/distance_ranking.hpp"

#include <array>
#include <cstdint>

namespace sylph {

DistanceRanking::DistanceRanking(const DistanceTables& distances, Rng& rng)
    : distances_(&distances), rng_(&rng) {}

void DistanceRanking::observe(const Vertices& /*configuration*/) {}

void DistanceRanking::rank(AgentId agent, VertexId /*at*/, Moves& moves) {
  std::array<std::int64_t, 5> keys{};
  for (int index = 0; index < moves.count; ++index) {
    const VertexId target = moves.targets[index];
    const std::int64_t distance = distances_->get(agent, target);
    const std::int64_t key =
        distance * (std::int64_t{1} << 32) + static_cast<std::int64_t>((*rng_)());
    int slot = index;
    for (; slot > 0 && keys[slot - 1] > key; --slot) {
      keys[slot] = keys[slot - 1];
      moves.targets[slot] = moves.targets[slot - 1];
    }
    keys[slot] = key;
    moves.targets[slot] = target;
  }
}

}  // namespace sylph
