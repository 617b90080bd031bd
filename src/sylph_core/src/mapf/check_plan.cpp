#include "sylph_core/mapf/check_plan.hpp"

#include <algorithm>
#include <unordered_map>

#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

/// Who is where in one configuration. As large as the map and reused, since plans of thousands of
/// agents are checked step by step.
class Occupants {
 public:
  explicit Occupants(const Grid& grid)
      : grid_(&grid), agents_(static_cast<std::size_t>(grid.size()), kNoAgent) {}

  /// @return who is on the cell of `agent` already, kNoAgent if it is placed there
  AgentId place(AgentId agent, const Cell& cell) {
    AgentId& occupant = slot(cell);
    if (occupant != kNoAgent) {
      return occupant;
    }
    occupant = agent;
    return kNoAgent;
  }
  AgentId at(const Cell& cell) const {
    return agents_[static_cast<std::size_t>(grid_->indexOf(cell))];
  }
  void clear(const Configuration& cells) {
    for (const Cell& cell : cells) {
      slot(cell) = kNoAgent;
    }
  }

  static constexpr AgentId kNoAgent = -1;

 private:
  AgentId& slot(const Cell& cell) {
    return agents_[static_cast<std::size_t>(grid_->indexOf(cell))];
  }

  const Grid* grid_;
  std::vector<AgentId> agents_;  // per cell
};

std::string agentAt(std::size_t agent, const Cell& cell) {
  return "agent " + std::to_string(agent) + " at " + toString(cell);
}

PlanViolation violation(ViolationKind kind, std::size_t timestep, std::vector<AgentId> agents,
                        const std::string& what) {
  return {kind, static_cast<Timestep>(timestep), std::move(agents),
          "step " + std::to_string(timestep) + ": " + what};
}

/// @param occupants  in: no agents; out: the agents, if there is no violation
std::optional<PlanViolation> checkConfiguration(const Grid& grid, const Configuration& cells,
                                                std::size_t timestep, Occupants& occupants) {
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    if (!grid.isFree(cells[agent])) {
      return violation(ViolationKind::NotFree, timestep, {static_cast<AgentId>(agent)},
                       agentAt(agent, cells[agent]) + ", which is not a free cell");
    }
    const AgentId other = occupants.place(static_cast<AgentId>(agent), cells[agent]);
    if (other != Occupants::kNoAgent) {
      return violation(
          ViolationKind::VertexConflict, timestep, {other, static_cast<AgentId>(agent)},
          agentAt(agent, cells[agent]) + ", where agent " + std::to_string(other) + " is too");
    }
  }
  return std::nullopt;
}

/// @param occupants  those of `from`
std::optional<PlanViolation> checkMoves(const Configuration& from, const Configuration& to,
                                        std::size_t timestep, const Occupants& occupants) {
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    if (manhattanDistance(from[agent], to[agent]) > 1) {
      return violation(ViolationKind::NotAdjacent, timestep, {static_cast<AgentId>(agent)},
                       "agent " + std::to_string(agent) + " jumps from " + toString(from[agent]) +
                           " to " + toString(to[agent]));
    }
  }
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    const AgentId other = occupants.at(to[agent]);
    // Each pair once; an agent that stays is its own occupant.
    if (other > static_cast<AgentId>(agent) && to[static_cast<std::size_t>(other)] == from[agent]) {
      return violation(ViolationKind::EdgeConflict, timestep, {static_cast<AgentId>(agent), other},
                       "agents " + std::to_string(agent) + " and " + std::to_string(other) +
                           " swap " + toString(from[agent]) + " and " + toString(to[agent]));
    }
  }
  return std::nullopt;
}

/// @param occupantOf  of a cell at the begin of the timestep: the agent, or -1
template <typename OccupantOf>
std::vector<std::vector<AgentId>> rotationsOf(const Configuration& to, OccupantOf occupantOf) {
  // Each agent points at the one whose cell it enters, so that each walk along the arrows ends, or
  // closes a rotation when it comes back to a member of its own chain.
  std::vector<std::vector<AgentId>> rotations;
  std::vector<bool> seen(to.size(), false);
  for (std::size_t first = 0; first < to.size(); ++first) {
    std::vector<AgentId> chain;
    auto agent = static_cast<AgentId>(first);
    while (agent != Occupants::kNoAgent && !seen[static_cast<std::size_t>(agent)]) {
      seen[static_cast<std::size_t>(agent)] = true;
      chain.push_back(agent);
      agent = occupantOf(to[static_cast<std::size_t>(agent)]);
    }
    const auto entry = std::find(chain.begin(), chain.end(), agent);
    if (chain.end() - entry > 2) {
      std::rotate(entry, std::min_element(entry, chain.end()), chain.end());
      rotations.emplace_back(entry, chain.end());
    }
  }
  return rotations;
}

}  // namespace

std::vector<std::vector<AgentId>> findRotations(const Configuration& from,
                                                const Configuration& to) {
  std::unordered_map<Cell, AgentId> occupants;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    occupants.emplace(from[agent], static_cast<AgentId>(agent));
  }
  return rotationsOf(to, [&](const Cell& cell) {
    const auto occupant = occupants.find(cell);
    return occupant == occupants.end() ? Occupants::kNoAgent : occupant->second;
  });
}

std::optional<PlanViolation> checkPlan(const Instance& instance, const Plan& plan) {
  if (plan.empty()) {
    return violation(ViolationKind::Empty, 0, {}, "the plan has no configuration");
  }
  Occupants occupants(instance.grid);
  for (std::size_t t = 0; t < plan.size(); ++t) {
    // All configurations before any move: moves are only judged between legal ones.
    if (plan[t].size() != instance.starts.size()) {
      return violation(ViolationKind::WrongAgentCount, t, {},
                       std::to_string(plan[t].size()) + " agents instead of " +
                           std::to_string(instance.starts.size()));
    }
    if (auto found = checkConfiguration(instance.grid, plan[t], t, occupants)) {
      return found;
    }
    occupants.clear(plan[t]);
  }
  for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
    if (plan.front()[agent] != instance.starts[agent]) {
      return violation(ViolationKind::WrongStart, 0, {static_cast<AgentId>(agent)},
                       agentAt(agent, plan.front()[agent]) + " instead of its start " +
                           toString(instance.starts[agent]));
    }
  }
  for (std::size_t t = 1; t < plan.size(); ++t) {
    for (std::size_t agent = 0; agent < plan[t].size(); ++agent) {
      occupants.place(static_cast<AgentId>(agent), plan[t - 1][agent]);
    }
    if (auto found = checkMoves(plan[t - 1], plan[t], t, occupants)) {
      return found;
    }
    if (!instance.motion.rotations) {
      const auto rotations =
          rotationsOf(plan[t], [&](const Cell& cell) { return occupants.at(cell); });
      if (!rotations.empty()) {
        return violation(ViolationKind::Rotation, t, rotations.front(),
                         "agents " + join(rotations.front(), ", ", [](AgentId agent) {
                           return std::to_string(agent);
                         }) + " rotate");
      }
    }
    occupants.clear(plan[t - 1]);
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
