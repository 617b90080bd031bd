#include "sylph_core/mapf/instance.hpp"

#include <stdexcept>
#include <string>
#include <unordered_map>

#include "sylph_core/grid/components.hpp"

namespace sylph {
namespace {

void requireFreeAndDistinct(const Grid& grid, const Configuration& cells, const std::string& what) {
  std::unordered_map<Cell, AgentId> owner;
  for (AgentId agent = 0; agent < static_cast<AgentId>(cells.size()); ++agent) {
    const Cell& cell = cells[static_cast<std::size_t>(agent)];
    const std::string subject = what + " " + toString(cell) + " of agent " + std::to_string(agent);
    if (!grid.isInside(cell)) {
      throw std::invalid_argument(subject + " lies outside the map of " +
                                  std::to_string(grid.rows()) + " x " +
                                  std::to_string(grid.cols()) + " cells");
    }
    if (!grid.isFree(cell)) {
      throw std::invalid_argument(subject + " lies on an obstacle");
    }
    const auto [other, is_new] = owner.emplace(cell, agent);
    if (!is_new) {
      throw std::invalid_argument(subject + " is also the " + what + " of agent " +
                                  std::to_string(other->second));
    }
  }
}

}  // namespace

void requireValid(const Instance& instance) {
  if (instance.starts.empty()) {
    throw std::invalid_argument("an instance needs at least one agent");
  }
  if (instance.starts.size() != instance.goals.size()) {
    throw std::invalid_argument(std::to_string(instance.starts.size()) + " starts but " +
                                std::to_string(instance.goals.size()) + " goals");
  }
  requireFreeAndDistinct(instance.grid, instance.starts, "start");
  requireFreeAndDistinct(instance.grid, instance.goals, "goal");
  const std::vector<int> label = connectedComponents(instance.grid).label;
  for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
    const auto component = [&](const Cell& cell) {
      return label[static_cast<std::size_t>(instance.grid.indexOf(cell))];
    };
    if (component(instance.starts[agent]) != component(instance.goals[agent])) {
      throw std::invalid_argument("goal " + toString(instance.goals[agent]) + " of agent " +
                                  std::to_string(agent) + " cannot be reached from its start " +
                                  toString(instance.starts[agent]));
    }
  }
}

}  // namespace sylph
