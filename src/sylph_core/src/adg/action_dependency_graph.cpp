#include "sylph_core/adg/action_dependency_graph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "task_builder.hpp"

namespace sylph {
namespace {

std::string describe(const Task& task, const std::string& name) {
  return "task " + std::to_string(task.id) + " (" + name + ", number " +
         std::to_string(task.sequence) + ", " + toString(task.start) + " to " + toString(task.end) +
         ")";
}

}  // namespace

ActionDependencyGraph::ActionDependencyGraph(const Plan& plan, std::vector<std::string> names)
    : names_(std::move(names)) {
  if (plan.empty()) {
    throw PlanRefused(0, {}, "the plan has no configuration");
  }
  for (std::size_t agent = names_.size(); agent < plan.front().size(); ++agent) {
    names_.push_back("agent " + std::to_string(agent));
  }
  names_.resize(plan.front().size());
  internal::TaskBuilder builder(names_, 0);
  for (std::size_t agent = 0; agent < names_.size(); ++agent) {
    builder.place(static_cast<AgentId>(agent), plan.front()[agent], 0);
    progress_.push_back({plan.front()[agent], {}, 0, 0});
  }
  std::vector<AgentId> agents(names_.size());
  std::iota(agents.begin(), agents.end(), 0);
  append(builder.build(agents, plan));
}

void ActionDependencyGraph::replaceRest(const CommitCut& cut, const std::vector<AgentId>& agents,
                                        const Plan& plan) {
  requireReplaceable(cut, agents, plan);
  std::vector<bool> takes_part(progress_.size(), false);
  for (const AgentId agent : agents) {
    takes_part[index(agent)] = true;
  }
  std::vector<Task> kept = tasksWithin(cut);
  // The builder begins anew, so it is told what the kept tasks leave behind: where everybody rests,
  // and which task left each cell last.
  internal::TaskBuilder builder(names_, static_cast<TaskId>(kept.size()));
  const Configuration rest = configurationAt(cut);
  for (AgentId agent = 0; agent < agentCount(); ++agent) {
    builder.place(agent, rest[index(agent)], cut[index(agent)]);
  }
  for (const Task& task : kept) {
    // Whoever takes no part in the new plan does no more: a cell that it has not left is held for
    // good.
    builder.addDeparture(task,
                         !takes_part[index(task.agent)] && task.sequence >= doneCount(task.agent));
  }
  std::vector<Task> added = builder.build(agents, plan);

  // No plan is refused from here on: the graph is either the old or the new one.
  tasks_.clear();
  for (Progress& progress : progress_) {
    progress.tasks.clear();
  }
  append(kept);
  append(added);
}

void ActionDependencyGraph::requireReplaceable(const CommitCut& cut,
                                               const std::vector<AgentId>& agents,
                                               const Plan& plan) const {
  if (!isClosed(cut)) {
    throw std::invalid_argument("a plan can only replace what lies behind a closed commit cut");
  }
  for (AgentId agent = 0; agent < agentCount(); ++agent) {
    if (cut[index(agent)] < releasedCount(agent)) {
      throw std::invalid_argument("the commit cut leaves out a task released to " + name(agent));
    }
  }
  if (plan.empty() || plan.front().size() != agents.size()) {
    throw PlanRefused(0, {}, "the plan does not start with one cell for each agent");
  }
  const Configuration rest = configurationAt(cut);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (plan.front()[i] != rest[index(agents[i])]) {
      throw PlanRefused(0, {agents[i]},
                        "the plan starts " + name(agents[i]) + " in " + toString(plan.front()[i]) +
                            " instead of " + toString(rest[index(agents[i])]) + ", where it rests");
    }
  }
}

std::vector<Task> ActionDependencyGraph::tasksWithin(const CommitCut& cut) const {
  std::vector<Task> kept;
  // Ids stay topologically sorted, as the tasks that are left keep their order. A predecessor is
  // within the cut, since the cut is closed, and has its new id by then.
  std::vector<TaskId> new_id(tasks_.size());
  for (const Task& task : tasks_) {
    if (task.sequence >= cut[index(task.agent)]) {
      continue;
    }
    Task copy = task;
    copy.id = static_cast<TaskId>(kept.size());
    new_id[index(task.id)] = copy.id;
    if (task.type2_predecessor) {
      copy.type2_predecessor = new_id[index(*task.type2_predecessor)];
    }
    kept.push_back(copy);
  }
  return kept;
}

void ActionDependencyGraph::append(const std::vector<Task>& tasks) {
  tasks_.reserve(tasks_.size() + tasks.size());
  for (const Task& task : tasks) {
    progress_[index(task.agent)].tasks.push_back(task.id);
    tasks_.push_back(task);
  }
  lookAtAll();
}

void ActionDependencyGraph::lookAtAll() {
  waiting_.clear();
  for (AgentId agent = 0; agent < agentCount(); ++agent) {
    to_look_at_.insert(to_look_at_.end(), agent);
  }
}

std::vector<TaskId> ActionDependencyGraph::dependencies(TaskId id) const {
  // Type-1 follows from the order of the agent's own tasks and is not stored; of type-2 the sparse
  // rule keeps one, whoever left the cell last: that task has those before it behind it.
  std::vector<TaskId> found;
  const Task& dependent = task(id);
  if (dependent.sequence > 0) {
    found.push_back(tasksOf(dependent.agent)[index(dependent.sequence - 1)]);
  }
  if (dependent.type2_predecessor) {
    found.push_back(*dependent.type2_predecessor);
  }
  return found;
}

TaskStatus ActionDependencyGraph::status(TaskId id) const {
  const Task& asked = task(id);
  const Progress& progress = progress_[index(asked.agent)];
  if (asked.sequence < progress.done) {
    return TaskStatus::Done;
  }
  return asked.sequence < progress.released ? TaskStatus::Enqueued : TaskStatus::Staged;
}

bool ActionDependencyGraph::isDone(TaskId id) const {
  return status(id) == TaskStatus::Done;
}

bool ActionDependencyGraph::mayRelease(const Task& task) const {
  return progress_[index(task.agent)].released == task.sequence &&
         (!task.type2_predecessor || isDone(*task.type2_predecessor));
}

std::vector<TaskId> ActionDependencyGraph::release(int lookahead,
                                                   const std::vector<AgentId>& except) {
  std::vector<TaskId> released;
  if (std::exchange(lookahead_, lookahead) != lookahead) {
    lookAtAll();
  }
  for (auto next_agent = to_look_at_.begin(); next_agent != to_look_at_.end();) {
    const AgentId agent = *next_agent;
    if (std::find(except.begin(), except.end(), agent) != except.end()) {
      ++next_agent;
      continue;
    }
    next_agent = to_look_at_.erase(next_agent);
    Progress& progress = progress_[index(agent)];
    while (progress.released < static_cast<int>(progress.tasks.size()) &&
           progress.released - progress.done < lookahead) {
      // In order, so that type-1 holds by itself: the robot carries out what it is given one after
      // the other.
      const TaskId next = progress.tasks[index(progress.released)];
      if (!mayRelease(task(next))) {
        waiting_[*task(next).type2_predecessor].push_back(agent);
        break;
      }
      ++progress.released;
      released.push_back(next);
    }
  }
  return released;
}

void ActionDependencyGraph::enqueue(TaskId id) {
  if (status(id) != TaskStatus::Staged) {
    return;
  }
  const Task& next = task(id);
  if (!mayRelease(next)) {
    throw std::invalid_argument(describe(next, name(next.agent)) +
                                " cannot be released before its dependencies");
  }
  ++progress_[index(next.agent)].released;
  to_look_at_.insert(next.agent);
}

std::vector<TaskId> ActionDependencyGraph::releasedTasks() const {
  std::vector<TaskId> released;
  for (const Progress& progress : progress_) {
    released.insert(released.end(), progress.tasks.begin() + progress.done,
                    progress.tasks.begin() + progress.released);
  }
  return released;
}

bool ActionDependencyGraph::complete(TaskId id) {
  if (isDone(id)) {
    return false;
  }
  const Task& completed = task(id);
  Progress& progress = progress_[index(completed.agent)];
  if (status(id) != TaskStatus::Enqueued || completed.sequence != progress.done) {
    throw std::invalid_argument(describe(completed, name(completed.agent)) +
                                " cannot be done: it is not released, or not the next");
  }
  ++progress.done;
  to_look_at_.insert(completed.agent);
  if (const auto waiting = waiting_.extract(id)) {
    to_look_at_.insert(waiting.mapped().begin(), waiting.mapped().end());
  }
  return true;
}

bool ActionDependencyGraph::isFinished() const {
  return std::all_of(progress_.begin(), progress_.end(), [](const Progress& progress) {
    return progress.done == static_cast<int>(progress.tasks.size());
  });
}

std::optional<TaskId> ActionDependencyGraph::currentTask(AgentId agent) const {
  const Progress& progress = progress_[index(agent)];
  if (progress.done == static_cast<int>(progress.tasks.size())) {
    return std::nullopt;
  }
  return progress.tasks[index(progress.done)];
}

const Cell& ActionDependencyGraph::cell(AgentId agent) const {
  const Progress& progress = progress_[index(agent)];
  return progress.done == 0 ? progress.start : task(progress.tasks[index(progress.done - 1)]).end;
}

Configuration ActionDependencyGraph::configuration() const {
  Configuration cells;
  for (AgentId agent = 0; agent < agentCount(); ++agent) {
    cells.push_back(cell(agent));
  }
  return cells;
}

std::vector<Cell> ActionDependencyGraph::heldCells(AgentId agent) const {
  const Progress& progress = progress_[index(agent)];
  std::vector<Cell> held = {cell(agent)};
  for (int k = progress.done; k < progress.released; ++k) {
    // A way that comes back to a cell holds it once.
    const Cell& end = task(progress.tasks[index(k)]).end;
    if (std::find(held.begin(), held.end(), end) == held.end()) {
      held.push_back(end);
    }
  }
  return held;
}

std::optional<Wait> ActionDependencyGraph::waitOf(AgentId agent) const {
  const std::optional<TaskId> current = currentTask(agent);
  if (!current || status(*current) != TaskStatus::Staged) {
    return std::nullopt;
  }
  const std::optional<TaskId>& predecessor = task(*current).type2_predecessor;
  if (!predecessor || isDone(*predecessor)) {
    return std::nullopt;
  }
  return Wait{*current, *predecessor};
}

std::vector<AgentId> ActionDependencyGraph::waitChain(AgentId agent) const {
  std::vector<AgentId> chain = {agent};
  // Each blocker precedes the task that waits for it, so the chain ends.
  for (std::optional<Wait> wait = waitOf(agent); wait; wait = waitOf(chain.back())) {
    chain.push_back(task(wait->blocker).agent);
  }
  return chain;
}

std::vector<AgentId> ActionDependencyGraph::blockedBy(const std::vector<AgentId>& agents) const {
  std::vector<bool> is_cause(progress_.size(), false);
  for (const AgentId agent : agents) {
    is_cause[index(agent)] = true;
  }
  std::vector<bool> is_blocked(tasks_.size(), false);
  std::vector<bool> agent_is_blocked(progress_.size(), false);
  for (const Task& task : tasks_) {
    if (isDone(task.id)) {
      continue;
    }
    // In the order of ids all dependencies have been decided before.
    const std::vector<TaskId> before = dependencies(task.id);
    is_blocked[index(task.id)] =
        is_cause[index(task.agent)] ||
        std::any_of(before.begin(), before.end(), [&](TaskId id) { return is_blocked[index(id)]; });
    if (is_blocked[index(task.id)] && !is_cause[index(task.agent)]) {
      agent_is_blocked[index(task.agent)] = true;
    }
  }
  std::vector<AgentId> blocked;
  for (AgentId agent = 0; agent < agentCount(); ++agent) {
    if (agent_is_blocked[index(agent)]) {
      blocked.push_back(agent);
    }
  }
  return blocked;
}

CommitCut ActionDependencyGraph::commitCut(int ahead) const {
  CommitCut cut;
  std::vector<TaskId> unchecked;
  for (const Progress& progress : progress_) {
    cut.push_back(std::min(progress.released + ahead, static_cast<int>(progress.tasks.size())));
    unchecked.insert(unchecked.end(), progress.tasks.begin() + progress.done,
                     progress.tasks.begin() + cut.back());
  }
  while (!unchecked.empty()) {
    // Who must leave a cell first has to get as far before the cut, and so has whoever that one
    // waits for. Tasks already behind the cut were looked at when they came in.
    const std::optional<TaskId> predecessor = task(unchecked.back()).type2_predecessor;
    unchecked.pop_back();
    if (!predecessor) {
      continue;
    }
    const Task& needed = task(*predecessor);
    int& committed = cut[index(needed.agent)];
    const std::vector<TaskId>& tasks = tasksOf(needed.agent);
    for (; committed <= needed.sequence; ++committed) {
      unchecked.push_back(tasks[index(committed)]);
    }
  }
  return cut;
}

bool ActionDependencyGraph::isClosed(const CommitCut& cut) const {
  if (cut.size() != progress_.size()) {
    return false;
  }
  for (std::size_t agent = 0; agent < cut.size(); ++agent) {
    if (cut[agent] < 0 || cut[agent] > static_cast<int>(progress_[agent].tasks.size())) {
      return false;
    }
  }
  return std::all_of(tasks_.begin(), tasks_.end(), [&](const Task& task) {
    if (task.sequence >= cut[index(task.agent)] || !task.type2_predecessor) {
      return true;
    }
    const Task& predecessor = tasks_[index(*task.type2_predecessor)];
    return predecessor.sequence < cut[index(predecessor.agent)];
  });
}

Configuration ActionDependencyGraph::configurationAt(const CommitCut& cut) const {
  Configuration cells;
  for (std::size_t agent = 0; agent < progress_.size(); ++agent) {
    const int committed = cut.at(agent);
    cells.push_back(committed == 0 ? progress_[agent].start
                                   : task(progress_[agent].tasks.at(index(committed - 1))).end);
  }
  return cells;
}

}  // namespace sylph
