#include "sylph_core/adg/explanation.hpp"

#include <algorithm>
#include <limits>

namespace sylph {
namespace {

void addTasks(const Execution& execution, int robot, RobotExecution& known) {
  const ActionDependencyGraph& graph = *execution.graph();
  const int first = execution.firstSequence(robot);
  const std::vector<TaskId>& tasks = graph.tasksOf(robot);
  const int done = graph.doneCount(robot);
  known.tasks_total = static_cast<int>(tasks.size()) - first;
  known.tasks_done = std::max(0, done - first);
  known.cell = graph.cell(robot);
  known.next_cell = known.cell;
  known.held_cells = graph.heldCells(robot);
  known.remaining_path = {known.cell};
  for (auto k = static_cast<std::size_t>(done); k < tasks.size(); ++k) {
    known.remaining_path.push_back(graph.task(tasks[k]).end);
  }
  // Done with its tasks it is at the last step of the plan, whose partner and SVO are shown.
  known.step = std::max(0, static_cast<Timestep>(execution.plan()->steps()) - 1);
  if (known.tasks_done < known.tasks_total) {
    const Task& current = graph.task(*graph.currentTask(robot));
    known.task_id = current.id;
    known.task_status = graph.status(current.id);
    known.action = current.action;
    known.next_cell = current.end;
    // Tasks of the plan before have timesteps of that plan.
    known.step = done >= first ? current.timestep : 0;
  }
}

void addSocialState(const Execution& execution, int robot, RobotExecution& known) {
  const MissionPlan& plan = *execution.plan();
  known.goal = execution.missionGoals().at(robot);
  const std::optional<AgentId> member = execution.agentOf(robot);
  // Lost before this plan was made: it has a goal still, and no partner.
  if (!member) {
    return;
  }
  const auto agent = static_cast<std::size_t>(*member);
  known.goal = plan.goals[agent];
  if (static_cast<std::size_t>(known.step) >= plan.social.size()) {
    return;
  }
  const SocialState& social = plan.social[static_cast<std::size_t>(known.step)];
  if (agent < social.svo_deg.size()) {
    known.svo_deg = social.svo_deg[agent];
  }
  if (agent < social.partners.size() && social.partners[agent] != static_cast<AgentId>(agent)) {
    // An agent that is its own partner has none.
    known.partner = plan.robots.at(static_cast<std::size_t>(social.partners[agent]));
  }
}

/// What a robot holds for by its own word, empty if it does not hold.
std::string holdingFor(const RobotMonitor& monitor) {
  const std::optional<RobotReport>& report = monitor.report();
  return report && report->state == RobotState::Holding ? report->detail : std::string();
}

std::string whyNotMoving(const Execution& execution, int robot, double now_s) {
  const RobotMonitor& monitor = execution.monitor(robot);
  // From what only a person can mend to what passes by itself.
  if (monitor.condition() != RobotCondition::Ok) {
    return monitor.trouble(now_s);
  }
  if (execution.mode() != ExecutionMode::Run) {
    const std::string& reason = execution.modeReason();
    return toString(execution.mode()) + (reason.empty() ? std::string() : ": " + reason);
  }
  // Known long before it counts as stuck.
  if (std::string reason = holdingFor(monitor); !reason.empty()) {
    return reason;
  }
  const ActionDependencyGraph& graph = *execution.graph();
  const std::optional<TaskId> current = graph.currentTask(robot);
  if (!current) {
    return "has no task left";
  }
  if (graph.status(*current) == TaskStatus::Staged) {
    return execution.isCut() ? "rests at the commit cut until the rest is planned anew"
                             : "its next task is not released yet";
  }
  const Task& task = graph.task(*current);
  return "is on its way from " + toString(task.start) + " to " + toString(task.end);
}

void addWait(const Execution& execution, int robot, double now_s, RobotExecution& known) {
  const ActionDependencyGraph& graph = *execution.graph();
  if (const std::optional<Wait> wait = graph.waitOf(robot)) {
    const Task& blocker = graph.task(wait->blocker);
    known.waits_for_robot = execution.name(blocker.agent);
    known.waits_for_task = blocker.id;
    known.waits_for_cell = blocker.start;
    known.waited_s = now_s - execution.waitsSince(robot).value_or(now_s);
  }
  // Whoever is told to look at a robot should look at the last one of the chain, not at the next.
  const int root = graph.waitChain(robot).back();
  const RobotMonitor& monitor = execution.monitor(root);
  const bool has_trouble =
      monitor.condition() != RobotCondition::Ok || !holdingFor(monitor).empty();
  const bool is_staged =
      known.tasks_done < known.tasks_total && known.task_status == TaskStatus::Staged;
  if (root != robot || has_trouble || is_staged) {
    known.root_cause_robot = execution.name(root);
    known.root_cause = whyNotMoving(execution, root, now_s);
  }
}

}  // namespace

RobotExecution explain(const Execution& execution, int robot, double now_s) {
  const RobotMonitor& monitor = execution.monitor(robot);
  const std::optional<RobotReport>& report = monitor.report();
  RobotExecution known;
  known.robot = execution.name(robot);
  known.condition = monitor.condition();
  known.report_state = report ? report->state : RobotState::Idle;
  known.is_aligning = execution.aligned() == robot;
  known.svo_deg = std::numeric_limits<float>::quiet_NaN();
  // Without part in the mission it is where it is, by its own word.
  if (execution.missionGoals().count(robot) == 0) {
    if (report && report->pose) {
      known.cell = execution.frame().toCell(position(*report->pose));
      known.next_cell = known.cell;
      known.goal = known.cell;
      known.held_cells = {known.cell};
      known.remaining_path = {known.cell};
    }
    return known;
  }
  addTasks(execution, robot, known);
  addSocialState(execution, robot, known);
  if (execution.isUnderWay()) {
    addWait(execution, robot, now_s, known);
  }
  return known;
}

AdgState explain(const Execution& execution, double now_s) {
  AdgState state;
  state.plan_id = execution.planId();
  state.last_plan_id = execution.lastPlanId();
  state.executed_plan_id = execution.executedPlanId();
  state.phase = execution.phase();
  state.mode = execution.mode();
  state.message = execution.message();
  state.steps = execution.plan() != nullptr ? execution.plan()->steps() : 0;
  for (int robot = 0; robot < execution.robotCount(); ++robot) {
    state.robots.push_back(explain(execution, robot, now_s));
  }
  return state;
}

int arrivedRobots(const Execution& execution) {
  int arrived = 0;
  for (const auto& [robot, goal] : execution.missionGoals()) {
    const ActionDependencyGraph& graph = *execution.graph();
    const bool is_there = !execution.monitor(robot).isLost() && !graph.currentTask(robot) &&
                          graph.cell(robot) == goal;
    arrived += is_there ? 1 : 0;
  }
  return arrived;
}

}  // namespace sylph
