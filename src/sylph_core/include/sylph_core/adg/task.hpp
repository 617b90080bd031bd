#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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
  Action action = Action::Stay;
  Cell start;
  Cell end;
  std::optional<TaskId> leaver;  ///< type-2 dependency: another agent's task that leaves `end`
};

/// A plan that cannot be carried out.
class PlanRefused : public std::invalid_argument {
 public:
  PlanRefused(Timestep timestep, std::vector<AgentId> agents, const std::string& message)
      : std::invalid_argument(message), timestep_(timestep), agents_(std::move(agents)) {}

  Timestep timestep() const { return timestep_; }
  const std::vector<AgentId>& agents() const { return agents_; }

 private:
  Timestep timestep_;
  std::vector<AgentId> agents_;
};

}  // namespace sylph
