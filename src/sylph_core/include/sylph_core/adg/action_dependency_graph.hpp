#pragma once

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "sylph_core/adg/plan_refused.hpp"
#include "sylph_core/execution/task.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// How many of its tasks each agent carries out: a state of execution in which everybody rests.
using CommitCut = std::vector<int>;

/// Why an agent's next task is not released: `blocker` has to leave the cell that `task` enters.
struct Wait {
  TaskId task = 0;     ///< that is not released
  TaskId blocker = 0;  ///< another agent's, not done
};

/// The order in which the moves of a plan may be carried out, whatever delays occur.
///
/// Type-1: a task follows the same agent's previous one. Type-2: a task that enters a cell follows
/// the task that leaves it at the same or an earlier timestep; of several, only the latest is kept,
/// since it follows the others. Hence a task has at most two dependencies, and the graph is built
/// in one pass over the plan. It has a cycle if and only if agents rotate in one
/// timestep; such a plan is refused.
///
/// An agent holds the start and end cell of each task that is released to it until that task is
/// done. Dependencies make the cells that different agents hold disjoint.
class ActionDependencyGraph {
 public:
  /// @param plan   configurations, starts first
  /// @param names  of the agents, for messages; "agent <i>" where empty
  /// @throws PlanRefused naming timestep and agents: no configuration, configurations of unequal
  /// width, a jump, agents that rotate or swap, an agent that enters a cell in which
  /// another one still is
  explicit ActionDependencyGraph(const Plan& plan, std::vector<std::string> names = {});

  /// Drops what lies behind the cut and goes on with a new plan from there. Task ids are given
  /// anew; sequences of what stays remain. Tasks that enter a cell which an unfinished old task
  /// leaves depend on that one.
  /// @param cut     isClosed(cut), and everything released is within it
  /// @param agents  who takes part; the others never move again, not even to finish released tasks
  /// @param plan    plan[t][i] is the cell of agents[i]; plan[0] is configurationAt(cut)
  /// @throws PlanRefused as the constructor; and if a start is not the cut's, or a cell is entered
  /// that an agent without part holds. The graph then remains as it was.
  /// @throws std::invalid_argument if the cut is not as demanded
  void replaceRest(const CommitCut& cut, const std::vector<AgentId>& agents, const Plan& plan);

  int agentCount() const { return static_cast<int>(progress_.size()); }
  int taskCount() const { return static_cast<int>(tasks_.size()); }
  /// Of the constructor, for messages.
  const std::string& name(AgentId agent) const { return names_[index(agent)]; }

  /// By id: dependencies first.
  const std::vector<Task>& tasks() const { return tasks_; }
  const Task& task(TaskId id) const { return tasks_[index(id)]; }
  /// By sequence.
  const std::vector<TaskId>& tasksOf(AgentId agent) const { return progress_[index(agent)].tasks; }
  /// Type-1, then type-2.
  std::vector<TaskId> dependencies(TaskId id) const;
  TaskStatus status(TaskId id) const;

  /// Releases what may be released, in order of agent and sequence. Only agents for which something
  /// has changed since the last call are looked at.
  ///
  /// With lookahead 1: tasks whose dependencies are all done. A greater lookahead releases up to
  /// that many tasks to an agent, so that it need not stop between them: those whose type-2
  /// dependency is done and whose type-1 dependency is released. That is as safe: the agent carries
  /// tasks out in order, and everybody else has left their cells for good or waits for this agent.
  /// @param lookahead  tasks that an agent may have released and not done, > 0
  /// @param except     agents that get nothing
  /// @return tasks that became Enqueued now
  std::vector<TaskId> release(int lookahead = 1, const std::vector<AgentId>& except = {});
  /// Releases one task, as an event log tells.
  /// @throws std::invalid_argument unless it is Enqueued or its dependencies allow it
  void enqueue(TaskId id);
  /// Enqueued tasks in order of agent and sequence.
  std::vector<TaskId> releasedTasks() const;

  /// Marks a task done. Idempotent.
  /// @return whether it was not done before
  /// @throws std::invalid_argument if it is not released, or the agent's previous task is not done
  bool complete(TaskId id);

  bool isFinished() const;
  /// Tasks of the agent that are Done; those before a cut count, too.
  int doneCount(AgentId agent) const { return progress_[index(agent)].done; }
  /// Tasks of the agent that are Enqueued or Done.
  int releasedCount(AgentId agent) const { return progress_[index(agent)].released; }
  /// The first task that is not done, or nothing if all are.
  std::optional<TaskId> currentTask(AgentId agent) const;
  /// Where the agent is: end of its last task done, or its start.
  const Cell& cell(AgentId agent) const;
  /// cell() of every agent.
  Configuration configuration() const;
  /// Cells that nobody else may enter now, in the order in which the agent comes to them.
  std::vector<Cell> heldCells(AgentId agent) const;

  /// Nothing if the agent has no task left or its current one is released or could be.
  std::optional<Wait> waitOf(AgentId agent) const;
  /// The agent, who it waits for, who that one waits for, ... The last one waits for nobody.
  std::vector<AgentId> waitChain(AgentId agent) const;
  /// Agents with a task that cannot be done before unfinished tasks of `agents`, without `agents`.
  std::vector<AgentId> blockedBy(const std::vector<AgentId>& agents) const;

  /// The smallest closed cut that contains what is released and, for each agent, `ahead` tasks
  /// more.
  CommitCut commitCut(int ahead = 0) const;
  /// Whether every task within the cut has its dependencies within it.
  bool isClosed(const CommitCut& cut) const;
  /// Where everybody rests at the cut; the cells are distinct if it is closed.
  Configuration configurationAt(const CommitCut& cut) const;

 private:
  struct Progress {
    Cell start;
    std::vector<TaskId> tasks;
    int done = 0;
    int released = 0;
  };

  template <typename Id>
  static std::size_t index(Id id) {
    return static_cast<std::size_t>(id);
  }
  bool isDone(TaskId id) const;
  bool mayRelease(const Task& task) const;
  void requireReplaceable(const CommitCut& cut, const std::vector<AgentId>& agents,
                          const Plan& plan) const;
  std::vector<Task> tasksWithin(const CommitCut& cut) const;
  void append(const std::vector<Task>& tasks);
  void lookAtAll();

  std::vector<std::string> names_;
  std::vector<Task> tasks_;
  std::vector<Progress> progress_;

  int lookahead_ = 0;             ///< of the last release()
  std::set<AgentId> to_look_at_;  ///< agents to which the next release() may give something
  /// The others that have a task left, by the task of another agent that theirs waits for.
  std::unordered_map<TaskId, std::vector<AgentId>> waiting_;
};

}  // namespace sylph
