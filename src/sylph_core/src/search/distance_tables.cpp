#include "sylph_core/search/distance_tables.hpp"

namespace sylph {

DistanceTables::DistanceTables(const Graph& graph, const Vertices& goals)
    : graph_(&graph), goals_(goals), tables_(goals.size()) {}

long DistanceTables::sum(const Vertices& configuration) const {
  long sum = 0;
  for (std::size_t agent = 0; agent < configuration.size(); ++agent) {
    sum += get(static_cast<AgentId>(agent), configuration[agent]);
  }
  return sum;
}

void DistanceTables::computeAll() const {
  for (std::size_t agent = 0; agent < tables_.size(); ++agent) {
    if (tables_[agent].empty()) {
      compute(static_cast<AgentId>(agent));
    }
  }
}

void DistanceTables::compute(AgentId agent) const {
  std::vector<std::int32_t>& table = tables_[static_cast<std::size_t>(agent)];
  table.assign(static_cast<std::size_t>(graph_->size()), kUnreachable);
  Vertices frontier;
  frontier.reserve(table.size());
  frontier.push_back(goals_[static_cast<std::size_t>(agent)]);
  table[static_cast<std::size_t>(frontier.front())] = 0;
  for (std::size_t next = 0; next < frontier.size(); ++next) {
    const std::int32_t distance = table[static_cast<std::size_t>(frontier[next])] + 1;
    for (const VertexId reached : graph_->neighbors(frontier[next])) {
      if (table[static_cast<std::size_t>(reached)] == kUnreachable) {
        table[static_cast<std::size_t>(reached)] = distance;
        frontier.push_back(reached);
      }
    }
  }
}

}  // namespace sylph
