#include "sylph_core/search/distance_tables.hpp"

#include <algorithm>

namespace sylph {

DistanceTables::DistanceTables(const Grid& grid, const Graph& graph, const Configuration& goals)
    : graph_(&graph), fields_(distancesTo(goals, grid)) {}

long DistanceTables::sum(const Vertices& configuration) const {
  long sum = 0;
  for (std::size_t agent = 0; agent < configuration.size(); ++agent) {
    sum += get(static_cast<AgentId>(agent), configuration[agent]);
  }
  return sum;
}

bool DistanceTables::reach(const Vertices& configuration, const Deadline& deadline) const {
  for (std::size_t agent = 0; agent < fields_.size(); ++agent) {
    if (!fields_[agent].reach(graph_->cellAt(configuration[agent]),
                              [&] { return deadline.isOver(); })) {
      return false;
    }
  }
  return true;
}

bool DistanceTables::completeAll(const Deadline& deadline) const {
  return std::all_of(fields_.begin(), fields_.end(), [&](const DistanceField& field) {
    return field.complete([&] { return deadline.isOver(); });
  });
}

}  // namespace sylph
