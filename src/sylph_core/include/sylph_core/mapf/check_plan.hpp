#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

enum class ViolationKind {
  Empty,
  WrongAgentCount,
  WrongStart,
  NotFree,
  NotAdjacent,
  VertexConflict,
  EdgeConflict,
  Rotation,
  GoalNotReached,
};

/// The first thing that is wrong with a plan.
struct PlanViolation {
  ViolationKind kind;
  Timestep timestep = 0;        ///< of the configuration in which it shows
  std::vector<AgentId> agents;  ///< who is involved
  std::string message;          ///< one line for people
};

/// The independent judge of every plan. Shares no code with any planner.
///
/// Checks that agents start at their starts, move between free adjacent cells, never share a cell
/// (vertex conflict), never swap along an edge (edge conflict), end on their goals, and, under
/// `motion.rotations == false`, never move round a ring in one timestep.
/// He et al. 2024 (arXiv:2408.03063), problem statement.
std::optional<PlanViolation> checkPlan(const Instance& instance, const Plan& plan);

/// The agents of each ring in which everybody enters the cell that the next one leaves, in ring
/// order, three agents at least, the lowest index of a ring first.
std::vector<std::vector<AgentId>> findRotations(const Configuration& from, const Configuration& to);

}  // namespace sylph
