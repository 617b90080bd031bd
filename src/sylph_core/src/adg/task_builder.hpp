#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "sylph_core/adg/plan_refused.hpp"
#include "sylph_core/execution/task.hpp"

namespace sylph::internal {

/// Turns a plan into tasks with their type-2 dependencies, in one pass.
///
/// For each cell it knows who is there and which task left it last. A task is made after the task
/// that leaves its end, even in the same timestep, so that ids sort the graph topologically.
class TaskBuilder {
 public:
  /// @param names      of the agents, for messages; outlives the builder
  /// @param first_id   id of the first task made
  TaskBuilder(const std::vector<std::string>& names, TaskId first_id)
      : names_(names), next_id_(first_id), agents_(names.size()) {}

  /// Puts an agent where it is when the plan begins.
  /// @param sequence  of its first task
  /// @throws PlanRefused if another agent is there
  void place(AgentId agent, const Cell& cell, int sequence);
  /// Tells of a task that was made before the plan and leaves a cell.
  /// @param never_done  nobody may enter that cell: its agent does not move again
  void addDeparture(const Task& task, bool never_done);

  /// @param agents  agents[i] moves along plan[.][i]; all others rest where they are
  /// @throws PlanRefused
  std::vector<Task> build(const std::vector<AgentId>& agents, const Plan& plan);

 private:
  using CellIndex = std::size_t;
  static constexpr AgentId kNoAgent = -1;

  struct CellState {
    AgentId occupant = kNoAgent;
    std::optional<TaskId> last_departure;
    AgentId departed_agent = kNoAgent;
    bool departure_never_done = false;
  };
  struct AgentState {
    Cell cell;
    CellIndex at = 0;
    Cell target_cell;
    CellIndex target = 0;
    int sequence = 0;
    Timestep moves_in = -1;  ///< last timestep in which it moves
    Timestep moved_in = -1;  ///< last timestep whose task has been made
    Timestep queued_in = -1;
  };

  AgentState& state(AgentId agent) { return agents_[static_cast<std::size_t>(agent)]; }
  const std::string& name(AgentId agent) const { return names_[static_cast<std::size_t>(agent)]; }
  CellIndex indexOf(const Cell& cell);
  void setTargets(const std::vector<AgentId>& agents, const Plan& plan, Timestep timestep);
  void makeTasksBehind(AgentId first, Timestep timestep, std::vector<Task>& tasks);
  Task makeTask(AgentId agent, Timestep timestep);
  [[noreturn]] void refuseRotation(std::vector<AgentId> queue, AgentId entry,
                                   Timestep timestep) const;
  [[noreturn]] void refuseEntry(AgentId agent, AgentId occupant, Timestep timestep);

  const std::vector<std::string>& names_;
  TaskId next_id_;
  std::vector<AgentState> agents_;
  std::vector<CellState> cells_;
  std::unordered_map<Cell, CellIndex> cell_index_;
};

}  // namespace sylph::internal
