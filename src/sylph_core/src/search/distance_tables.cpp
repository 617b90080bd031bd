#include "sylph_core/search/distance_tables.hpp"

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

void DistanceTables::completeAll() const {
  for (const DistanceField& field : fields_) {
    field.complete();
  }
}

}  // namespace sylph
