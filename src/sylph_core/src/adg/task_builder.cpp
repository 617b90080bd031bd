#include "task_builder.hpp"

#include <algorithm>

#include "sylph_core/text/join.hpp"

namespace sylph::internal {
namespace {

std::string atStep(Timestep timestep) {
  return "step " + std::to_string(timestep) + ": ";
}

}  // namespace

TaskBuilder::CellIndex TaskBuilder::indexOf(const Cell& cell) {
  const auto [entry, is_new] = cell_index_.emplace(cell, cells_.size());
  if (is_new) {
    cells_.emplace_back();
  }
  return entry->second;
}

void TaskBuilder::place(AgentId agent, const Cell& cell, int sequence) {
  AgentState& placed = state(agent);
  placed.cell = cell;
  placed.at = indexOf(cell);
  placed.sequence = sequence;
  AgentId& occupant = cells_[placed.at].occupant;
  if (occupant != kNoAgent) {
    throw PlanRefused(
        0, {occupant, agent},
        atStep(0) + name(occupant) + " and " + name(agent) + " both start in " + toString(cell));
  }
  occupant = agent;
}

void TaskBuilder::addDeparture(const Task& task, bool never_done) {
  CellState& cell = cells_[indexOf(task.start)];
  // The task that leaves a cell later has the greater id: it follows the earlier one.
  if (!cell.last_departure || *cell.last_departure < task.id) {
    cell.last_departure = task.id;
    cell.departed_agent = task.agent;
    cell.departure_never_done = never_done;
  }
}

std::vector<Task> TaskBuilder::build(const std::vector<AgentId>& agents, const Plan& plan) {
  std::vector<Task> tasks;
  // Waits make no task: an agent that stays has nothing to send, and who follows waits for a task,
  // not for a timestep.
  for (std::size_t t = 0; t + 1 < plan.size(); ++t) {
    const auto timestep = static_cast<Timestep>(t);
    setTargets(agents, plan, timestep);
    for (const AgentId agent : agents) {
      if (state(agent).moves_in == timestep) {
        makeTasksBehind(agent, timestep, tasks);
      }
    }
  }
  return tasks;
}

void TaskBuilder::setTargets(const std::vector<AgentId>& agents, const Plan& plan,
                             Timestep timestep) {
  const Configuration& next = plan[static_cast<std::size_t>(timestep) + 1];
  if (next.size() != agents.size()) {
    throw PlanRefused(timestep, {},
                      atStep(timestep) + "leads to a configuration of " +
                          std::to_string(next.size()) + " agents instead of " +
                          std::to_string(agents.size()));
  }
  for (std::size_t i = 0; i < agents.size(); ++i) {
    AgentState& mover = state(agents[i]);
    if (next[i] == mover.cell) {
      continue;
    }
    if (!actionBetween(mover.cell, next[i])) {
      throw PlanRefused(timestep, {agents[i]},
                        atStep(timestep) + name(agents[i]) + " jumps from " + toString(mover.cell) +
                            " to " + toString(next[i]));
    }
    mover.target_cell = next[i];
    mover.target = indexOf(next[i]);
    mover.moves_in = timestep;
  }
}

void TaskBuilder::makeTasksBehind(AgentId first, Timestep timestep, std::vector<Task>& tasks) {
  // Who enters an occupied cell has to wait until its occupant's task has been made.
  std::vector<AgentId> queue;
  AgentId agent = first;
  while (state(agent).moved_in != timestep) {
    state(agent).queued_in = timestep;
    queue.push_back(agent);
    const AgentId occupant = cells_[state(agent).target].occupant;
    if (occupant == kNoAgent) {
      break;
    }
    const AgentState& ahead = state(occupant);
    // It stays, or has just come in itself.
    if (ahead.moves_in != timestep || ahead.moved_in == timestep) {
      refuseEntry(agent, occupant, timestep);
    }
    // The queue bites its own tail: as each waits for the next to have left, none would ever move.
    if (ahead.queued_in == timestep) {
      refuseRotation(std::move(queue), occupant, timestep);
    }
    agent = occupant;
  }
  for (; !queue.empty(); queue.pop_back()) {
    tasks.push_back(makeTask(queue.back(), timestep));
  }
}

Task TaskBuilder::makeTask(AgentId agent, Timestep timestep) {
  AgentState& mover = state(agent);
  CellState& left = cells_[mover.at];
  CellState& entered = cells_[mover.target];
  Task task;
  task.id = next_id_++;
  task.agent = agent;
  task.sequence = mover.sequence++;
  task.timestep = timestep;
  task.action = actionBetween(mover.cell, mover.target_cell).value();
  task.start = mover.cell;
  task.end = mover.target_cell;
  // Of all who have left the cell the last is enough: it could only enter when those before had
  // left. Back into a cell of its own an agent comes by its own order.
  if (entered.last_departure && entered.departed_agent != agent) {
    if (entered.departure_never_done) {
      refuseEntry(agent, entered.departed_agent, timestep);
    }
    task.type2_predecessor = entered.last_departure;
  }
  left = {kNoAgent, task.id, agent, false};
  entered.occupant = agent;
  mover.cell = mover.target_cell;
  mover.at = mover.target;
  mover.moved_in = timestep;
  return task;
}

void TaskBuilder::refuseRotation(std::vector<AgentId> queue, AgentId entry,
                                 Timestep timestep) const {
  queue.erase(queue.begin(), std::find(queue.begin(), queue.end(), entry));
  std::rotate(queue.begin(), std::min_element(queue.begin(), queue.end()), queue.end());
  const std::string members =
      join(queue, ", ", [this](const AgentId agent) { return name(agent); });
  throw PlanRefused(timestep, queue,
                    atStep(timestep) + members +
                        (queue.size() == 2 ? " swap their cells" : " rotate") +
                        ", so that each would wait for the next one for ever");
}

void TaskBuilder::refuseEntry(AgentId agent, AgentId occupant, Timestep timestep) {
  throw PlanRefused(timestep, {agent, occupant},
                    atStep(timestep) + name(agent) + " enters " +
                        toString(state(agent).target_cell) + ", which " + name(occupant) +
                        " holds and does not leave by then");
}

}  // namespace sylph::internal
