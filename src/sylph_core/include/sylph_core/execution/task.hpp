#pragma once

#include <optional>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/cell.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

using TaskId = int;  ///< index of a task in its graph, from 0; a task's dependencies have lower ids

/// Staged: not released. Enqueued: released to its robot. Done: the robot has arrived.
enum class TaskStatus { Staged = 0, Enqueued = 1, Done = 2 };

/// A move of one agent. Waits are no tasks: who waits has nothing to do.
/// He et al. 2024 (arXiv:2408.03063), appendix on execution.
struct Task {
  TaskId id = 0;
  AgentId agent = 0;
  int sequence = 0;       ///< the agent's k-th task, from 0; its (k-1)-th is its type-1 dependency
  Timestep timestep = 0;  ///< t of the move t -> t + 1 in its plan
  Action action = Action::Stay;  ///< never Stay
  Cell start;                    ///< held until the task is done
  Cell end;                      ///< held until the next one is done
  std::optional<TaskId>
      type2_predecessor;  ///< type-2 dependency: another agent's task that leaves `end`
};

}  // namespace sylph
