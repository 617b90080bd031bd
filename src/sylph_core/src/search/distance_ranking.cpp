#include "sylph_core/search/distance_ranking.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace sylph {

DistanceRanking::DistanceRanking(const DistanceTables& distances, const GuidePaths& guides,
                                 Rng& rng)
    : distances_(&distances), guides_(&guides), rng_(&rng) {}

void DistanceRanking::observe(const Vertices& /*configuration*/) {}

void DistanceRanking::rank(AgentId agent, VertexId at, Moves& moves) {
  const VertexId guided = guides_->next(agent, at);
  std::array<std::int64_t, 5> keys{};
  for (int index = 0; index < moves.count; ++index) {
    const VertexId target = moves.targets[index];
    const std::int64_t distance = target == guided ? -1 : distances_->get(agent, target);
    const std::int64_t key = distance * (std::int64_t{1} << 32) + (*rng_)();
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
