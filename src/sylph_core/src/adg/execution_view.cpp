// What is known of the execution, for people and messages.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sylph_core/adg/execution.hpp"

namespace sylph {

int Execution::arrivedRobots() const {
  int arrived = 0;
  for (const auto& [robot, goal] : mission_goals_) {
    const bool is_there = !robots_[index(robot)].monitor.isLost() && !graph_->currentTask(robot) &&
                          graph_->cell(robot) == goal;
    arrived += is_there ? 1 : 0;
  }
  return arrived;
}

RobotView Execution::view(int robot, double now_s) const {
  const Robot& viewed = robots_.at(index(robot));
  const std::optional<RobotReport>& report = viewed.monitor.report();
  RobotView view;
  view.condition = viewed.monitor.condition();
  view.report_state = report ? report->state : RobotState::Idle;
  view.svo_deg = std::numeric_limits<float>::quiet_NaN();
  if (mission_goals_.count(robot) == 0) {
    if (report && report->pose) {
      view.cell = frame_.toCell(position(*report->pose));
      view.goal = view.cell;
      view.held_cells = {view.cell};
      view.remaining_path = {view.cell};
    }
    return view;
  }
  fillTask(robot, view);
  fillSocialState(robot, view);
  fillWait(robot, now_s, view);
  return view;
}

void Execution::fillTask(int robot, RobotView& view) const {
  const int first = robots_[index(robot)].first_sequence;
  const std::vector<TaskId>& tasks = graph_->tasksOf(robot);
  const int done = graph_->doneCount(robot);
  view.tasks_total = static_cast<int>(tasks.size()) - first;
  view.tasks_done = std::max(0, done - first);
  view.cell = graph_->cell(robot);
  view.held_cells = graph_->heldCells(robot);
  view.remaining_path = {view.cell};
  for (std::size_t k = index(done); k < tasks.size(); ++k) {
    view.remaining_path.push_back(graph_->task(tasks[k]).end);
  }
  view.step = std::max(0, static_cast<Timestep>(plan_->steps()) - 1);
  if (view.tasks_done < view.tasks_total) {
    const TaskId current = *graph_->currentTask(robot);
    view.task = graph_->task(current);
    view.task_status = graph_->status(current);
    view.step = done >= first ? view.task->timestep : 0;
  }
}

void Execution::fillSocialState(int robot, RobotView& view) const {
  view.goal = mission_goals_.at(robot);
  const auto member = std::find(plan_->robots.begin(), plan_->robots.end(), name(robot));
  if (member == plan_->robots.end()) {
    return;
  }
  const auto agent = static_cast<std::size_t>(member - plan_->robots.begin());
  view.goal = plan_->goals[agent];
  if (index(view.step) >= plan_->social.size()) {
    return;
  }
  const SocialState& social = plan_->social[index(view.step)];
  if (agent < social.svo_deg.size()) {
    view.svo_deg = social.svo_deg[agent];
  }
  if (agent < social.partners.size() && social.partners[agent] != static_cast<AgentId>(agent)) {
    view.partner = plan_->robots.at(index(social.partners[agent]));
  }
}

void Execution::fillWait(int robot, double now_s, RobotView& view) const {
  if (!isUnderWay()) {
    return;
  }
  if (const std::optional<Wait> wait = graph_->waitOf(robot)) {
    const Task& blocker = graph_->task(wait->blocker);
    const std::optional<double>& since_s = robots_[index(robot)].waits_since_s;
    view.waits_for_robot = name(blocker.agent);
    view.waits_for_task = blocker.id;
    view.waits_for_cell = blocker.start;
    view.waited_s = since_s ? now_s - *since_s : 0.0;
  }
  const int root = graph_->waitChain(robot).back();
  const bool has_trouble = robots_[index(root)].monitor.condition() != RobotCondition::Ok;
  if (root != robot || has_trouble || (view.task && view.task_status == TaskStatus::Staged)) {
    view.root_cause_robot = name(root);
    view.root_cause = whyNotMoving(root, now_s);
  }
}

std::string Execution::whyNotMoving(int robot, double now_s) const {
  const RobotMonitor& monitor = robots_[index(robot)].monitor;
  if (monitor.condition() != RobotCondition::Ok) {
    return monitor.trouble(now_s);
  }
  if (mode_ != ExecutionMode::Run) {
    return toString(mode_) + (mode_reason_.empty() ? std::string() : ": " + mode_reason_);
  }
  const std::optional<TaskId> current = graph_->currentTask(robot);
  if (!current) {
    return "has no task left";
  }
  if (graph_->status(*current) == TaskStatus::Staged) {
    return is_cut_ ? "rests at the commit cut until the rest is planned anew"
                   : "its next task is not released yet";
  }
  const Task& task = graph_->task(*current);
  return "is on its way from " + toString(task.start) + " to " + toString(task.end);
}

}  // namespace sylph
