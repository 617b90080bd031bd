#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// What a plan can be guilty of.
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
  ViolationKind kind;           ///< the rule that is broken
  Timestep timestep = 0;        ///< of the configuration in which it shows
  std::vector<AgentId> agents;  ///< who is involved
  std::string message;          ///< one line for the operator
};

/// The independent judge of every plan. Shares no code with any planner.
///
/// Checks that agents start at their starts, move between free adjacent cells, never share a cell
/// (vertex conflict), never swap along an edge (edge conflict), end on their goals, and, under
/// `motion.rotations == false`, never rotate.
/// He et al. 2024 (arXiv:2408.03063), problem statement.
std::optional<PlanViolation> checkPlan(const Instance& instance, const Plan& plan);

/// The agents of each rotation, a cycle in which each enters the cell that the next one leaves, in
/// the order of the cycle, three agents at least, the lowest index first.
std::vector<std::vector<AgentId>> findRotations(const Configuration& from, const Configuration& to);

}  // namespace sylph
