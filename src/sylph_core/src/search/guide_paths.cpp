#include "sylph_core/search/guide_paths.hpp"

#include <algorithm>

namespace sylph {

GuidePaths GuidePaths::spreadOut(const Graph& /*graph*/, const Vertices& /*starts*/,
                                 const Vertices& /*goals*/, const DistanceTables& /*distances*/,
                                 int /*detour*/, const Deadline& /*deadline*/, Rng& /*rng*/) {
  return {};
}

VertexId GuidePaths::next(AgentId agent, VertexId at) const {
  if (next_.empty()) {
    return kNoVertex;
  }
  const auto& hints = next_[static_cast<std::size_t>(agent)];
  const auto found = std::lower_bound(hints.begin(), hints.end(), std::make_pair(at, kNoVertex));
  return found != hints.end() && found->first == at ? found->second : kNoVertex;
}

}  // namespace sylph
