#include "sylph_core/mapf/check_plan.hpp"

#include <algorithm>
#include <unordered_map>

namespace sylph {
namespace {

std::string agentAt(std::size_t agent, const Cell& cell) {
  return "agent " + std::to_string(agent) + " at " + toString(cell);
}

PlanViolation violation(ViolationKind kind, std::size_t timestep, std::vector<AgentId> agents,
                        const std::string& what) {
  return {kind, static_cast<Timestep>(timestep), std::move(agents),
          "step " + std::to_string(timestep) + ": " + what};
}

std::optional<PlanViolation> checkConfiguration(const Grid& grid, const Configuration& cells,
                                                std::size_t timestep) {
  std::unordered_map<Cell, std::size_t> occupant;
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    if (!grid.isFree(cells[agent])) {
      return violation(ViolationKind::NotFree, timestep, {static_cast<AgentId>(agent)},
                       agentAt(agent, cells[agent]) + ", which is not a free cell");
    }
    const auto [other, is_new] = occupant.emplace(cells[agent], agent);
    if (!is_new) {
      return violation(ViolationKind::VertexConflict, timestep,
                       {static_cast<AgentId>(other->second), static_cast<AgentId>(agent)},
                       agentAt(agent, cells[agent]) + ", where agent " +
                           std::to_string(other->second) + " is too");
    }
  }
  return std::nullopt;
}

std::optional<PlanViolation> checkMoves(const Configuration& from, const Configuration& to,
                                        std::size_t timestep) {
  std::unordered_map<Cell, std::size_t> occupant;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    if (manhattanDistance(from[agent], to[agent]) > 1) {
      return violation(ViolationKind::NotAdjacent, timestep, {static_cast<AgentId>(agent)},
                       "agent " + std::to_string(agent) + " jumps from " + toString(from[agent]) +
                           " to " + toString(to[agent]));
    }
    occupant.emplace(from[agent], agent);
  }
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    const auto other = occupant.find(to[agent]);
    if (other == occupant.end() || other->second <= agent) {
      continue;
    }
    if (to[other->second] == from[agent]) {
      return violation(ViolationKind::EdgeConflict, timestep,
                       {static_cast<AgentId>(agent), static_cast<AgentId>(other->second)},
                       "agents " + std::to_string(agent) + " and " + std::to_string(other->second) +
                           " swap " + toString(from[agent]) + " and " + toString(to[agent]));
    }
  }
  return std::nullopt;
}

std::string listOf(const std::vector<AgentId>& agents) {
  std::string text;
  for (const AgentId agent : agents) {
    text += (text.empty() ? "" : ", ") + std::to_string(agent);
  }
  return text;
}

}  // namespace

std::vector<std::vector<AgentId>> findRotations(const Configuration& from,
                                                const Configuration& to) {
  std::unordered_map<Cell, AgentId> occupant;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    occupant.emplace(from[agent], static_cast<AgentId>(agent));
  }
  // Everybody points at the agent whose cell it enters, so each walk along the arrows ends, or
  // closes a ring when it comes back to a member of its own chain.
  std::vector<std::vector<AgentId>> rings;
  std::vector<bool> seen(from.size(), false);
  for (std::size_t first = 0; first < from.size(); ++first) {
    std::vector<AgentId> chain;
    auto agent = static_cast<AgentId>(first);
    while (!seen[static_cast<std::size_t>(agent)]) {
      seen[static_cast<std::size_t>(agent)] = true;
      chain.push_back(agent);
      const auto next = occupant.find(to[static_cast<std::size_t>(agent)]);
      if (next == occupant.end()) {
        break;
      }
      agent = next->second;
    }
    const auto entry = std::find(chain.begin(), chain.end(), agent);
    if (chain.end() - entry > 2) {
      std::rotate(entry, std::min_element(entry, chain.end()), chain.end());
      rings.emplace_back(entry, chain.end());
    }
  }
  return rings;
}

std::optional<PlanViolation> checkPlan(const Instance& instance, const Plan& plan) {
  if (plan.empty()) {
    return violation(ViolationKind::Empty, 0, {}, "the plan has no configuration");
  }
  for (std::size_t t = 0; t < plan.size(); ++t) {
    if (plan[t].size() != instance.starts.size()) {
      return violation(ViolationKind::WrongAgentCount, t, {},
                       std::to_string(plan[t].size()) + " agents instead of " +
                           std::to_string(instance.starts.size()));
    }
    if (auto found = checkConfiguration(instance.grid, plan[t], t)) {
      return found;
    }
  }
  for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
    if (plan.front()[agent] != instance.starts[agent]) {
      return violation(ViolationKind::WrongStart, 0, {static_cast<AgentId>(agent)},
                       agentAt(agent, plan.front()[agent]) + " instead of its start " +
                           toString(instance.starts[agent]));
    }
  }
  for (std::size_t t = 1; t < plan.size(); ++t) {
    if (auto found = checkMoves(plan[t - 1], plan[t], t)) {
      return found;
    }
    if (!instance.motion.rotations) {
      const auto rings = findRotations(plan[t - 1], plan[t]);
      if (!rings.empty()) {
        return violation(ViolationKind::Rotation, t, rings.front(),
                         "agents " + listOf(rings.front()) + " move round a ring");
      }
    }
  }
  for (std::size_t agent = 0; agent < instance.goals.size(); ++agent) {
    if (plan.back()[agent] != instance.goals[agent]) {
      return violation(ViolationKind::GoalNotReached, plan.size() - 1,
                       {static_cast<AgentId>(agent)},
                       agentAt(agent, plan.back()[agent]) + " instead of its goal " +
                           toString(instance.goals[agent]));
    }
  }
  return std::nullopt;
}

}  // namespace sylph
