#include "sylph_core/adg/execution.hpp"

#include <algorithm>
#include <stdexcept>

namespace sylph {

Execution::Execution(std::vector<std::string> robots, int rows, int cols, double cell_size_m,
                     const ExecutionLimits& limits, const Point& corner)
    : names_(std::move(robots)),
      frame_(rows, cell_size_m, corner),
      limits_(limits),
      admission_(names_, rows, cols, frame_, limits),
      monitors_(names_.size(), RobotMonitor(limits)),
      deliveries_(names_.size()) {
  for (int robot = 0; robot < robotCount(); ++robot) {
    indices_.emplace(names_[index(robot)], robot);
  }
}

std::optional<int> Execution::indexOf(const std::string& name) const {
  const auto found = indices_.find(name);
  return found == indices_.end() ? std::nullopt : std::make_optional(found->second);
}

std::optional<AgentId> Execution::agentOf(int robot) const {
  const auto found = agents_.find(robot);
  return found == agents_.end() ? std::nullopt : std::make_optional(found->second);
}

void Execution::setPhase(ExecutionPhase phase) {
  if (phase_ != phase) {
    phase_ = phase;
    log(event::Phase{phase});
  }
}

bool Execution::setMode(ExecutionMode mode, const std::string& reason) {
  if (mode == ExecutionMode::Run && is_emergency_) {
    return false;
  }
  // Robots that are paused finish their tasks: who is stopped must not drive on for that.
  const bool is_looser = mode == ExecutionMode::Pause && mode_ == ExecutionMode::Stop;
  if (mode_ != mode && !is_looser) {
    mode_ = mode;
    mode_reason_ = mode == ExecutionMode::Run ? std::string() : reason;
    log(event::Mode{mode, reason});
    advance();
  }
  return true;
}

void Execution::setEmergencyStop(bool is_pressed, const std::string& reason) {
  is_emergency_ = is_pressed;
  if (is_pressed) {
    setMode(ExecutionMode::Stop, reason);
  }
}

void Execution::declareLost(int robot, const std::string& reason) {
  RobotMonitor& monitor = monitors_.at(index(robot));
  if (monitor.isLost()) {
    return;
  }
  monitor.setLost();
  log(event::Lost{robot, reason});
  advance();
}

void Execution::report(int robot, const RobotReport& report, double now_s) {
  if (!monitors_.at(index(robot)).accept(report, now_s)) {
    return;
  }
  // A robot may remember a plan of an earlier run; new plans are numbered after it.
  last_plan_id_ = std::max(last_plan_id_, report.plan_id);
  const bool has_done_more = graph_ && takeCounts(robot, report, now_s);
  const bool is_decided = tryStart(now_s);
  // Most reports bring nothing new, and to advance is to look at every robot.
  if (has_done_more || is_decided) {
    advance();
  }
}

bool Execution::takeCounts(int robot, const RobotReport& report, double now_s) {
  Delivery& delivery = deliveries_[index(robot)];
  const bool is_this_plan = report.plan_id == plan_->plan_id;
  const int released = releasedCount(robot);
  // What was never released cannot have come: a count beyond it is of a plan of the same number in
  // an earlier run.
  const int accepted = is_this_plan ? std::min(report.accepted, released) : 0;
  if (accepted < delivery.accepted) {
    // Its node was started again and has forgotten: everything is sent once more.
    std::fill(delivery.sent_s.begin(), delivery.sent_s.end(), std::nullopt);
    undelivered_.insert(robot);
  } else if (accepted > delivery.accepted) {
    logOfPlan(event::Accepted{robot, accepted});
  }
  delivery.accepted = accepted;
  const int done = is_this_plan ? std::min(report.done, released) : 0;
  // Below 0 are unfinished tasks of a lost robot, of the plan before: this plan's counts say
  // nothing of them.
  const int first = std::max(0, graph_->doneCount(robot) - delivery.first_sequence);
  for (int k = first; k < done; ++k) {
    graph_->complete(taskOf(robot, k));
    monitors_[index(robot)].noteProgress(now_s);
    logOfPlan(event::Done{robot, k});
  }
  return first < done;
}

void Execution::tick(double now_s) {
  updateConditions(now_s);
  tryStart(now_s);
  advance();
  updateWaits(now_s);
}

void Execution::updateConditions(double now_s) {
  for (int robot = 0; robot < robotCount(); ++robot) {
    RobotMonitor& monitor = monitors_[index(robot)];
    const bool has_tasks = isUnderWay() && graph_->currentTask(robot).has_value();
    // A robot that waits for others, or is stopped, may stand for as long as it likes.
    const bool should_move = has_tasks && hasReleased(robot) && mode_ != ExecutionMode::Stop;
    if (monitor.update(should_move, now_s)) {
      log(event::Condition{robot, monitor.condition(), monitor.trouble(now_s)});
    }
    const std::optional<double> since_s = monitor.troubleSince();
    // Only while robots run: who pauses the lab to mend a robot does not want it given up.
    if (limits_.lost_after_s > 0.0 && has_tasks && mode_ == ExecutionMode::Run && since_s &&
        !monitor.isLost() && now_s - *since_s > limits_.lost_after_s) {
      declareLost(robot, monitor.trouble(now_s));
    }
  }
}

void Execution::updateWaits(double now_s) {
  for (int robot = 0; graph_ && robot < robotCount(); ++robot) {
    std::optional<double>& waits_s = deliveries_[index(robot)].waits_s;
    if (!isUnderWay() || !graph_->waitOf(robot)) {
      waits_s.reset();
    } else if (!waits_s) {
      waits_s = now_s;
    }
  }
}

void Execution::advance() {
  if (!graph_ || is_abandoned_ || phase_ == ExecutionPhase::Refused) {
    return;
  }
  const std::vector<AgentId> lost = lostRobots();
  const auto noLiveRobot = [&](const auto& predicate) {
    for (int robot = 0; robot < robotCount(); ++robot) {
      if (!monitors_[index(robot)].isLost() && predicate(robot)) {
        return false;
      }
    }
    return true;
  };
  // Where a lost robot is in nobody's way, the others just go on.
  if (phase_ == ExecutionPhase::Executing && !lost.empty() && !graph_->blockedBy(lost).empty()) {
    is_cut_ = true;
    setPhase(ExecutionPhase::Cutting);
  }
  // Not after a cut: each task more would lie behind what the replacement starts from.
  if (phase_ == ExecutionPhase::Executing) {
    release(lost);
    if (noLiveRobot([&](int robot) { return graph_->currentTask(robot).has_value(); })) {
      setPhase(ExecutionPhase::Finished);
    }
  }
  if (phase_ == ExecutionPhase::Cutting &&
      noLiveRobot([&](int robot) { return hasReleased(robot); })) {
    setPhase(ExecutionPhase::AtCut);
  }
}

void Execution::release(const std::vector<AgentId>& lost) {
  if (mode_ != ExecutionMode::Run) {
    return;
  }
  // Written down before takeOrders() hands it out: decided once, and after a restart known.
  for (const TaskId released : graph_->release(limits_.lookahead, lost)) {
    const Task& task = graph_->task(released);
    undelivered_.insert(task.agent);
    logOfPlan(event::Released{task.agent, task.sequence - firstSequence(task.agent)});
  }
}

std::vector<ExecutionEvent> Execution::takeEvents() {
  return std::exchange(events_, {});
}

std::vector<TaskOrder> Execution::takeOrders(double now_s) {
  std::vector<TaskOrder> orders;
  for (auto next = undelivered_.begin(); graph_ && next != undelivered_.end();) {
    const int robot = *next;
    Delivery& delivery = deliveries_[index(robot)];
    const int released = releasedCount(robot);
    if (delivery.accepted >= released) {
      next = undelivered_.erase(next);
      continue;
    }
    ++next;
    // What a robot has is known from its reports only, so that after a restart of this end too
    // nothing is sent to a robot before it has told.
    if (monitors_[index(robot)].isLost() || !monitors_[index(robot)].report()) {
      continue;
    }
    const int total = static_cast<int>(graph_->tasksOf(robot).size()) - delivery.first_sequence;
    delivery.sent_s.resize(index(released));
    for (int k = delivery.accepted; k < released; ++k) {
      std::optional<double>& sent_s = delivery.sent_s[index(k)];
      if (sent_s && now_s - *sent_s < limits_.resend_after_s) {
        continue;
      }
      sent_s = now_s;
      const Task& task = graph_->task(taskOf(robot, k));
      orders.push_back({plan_->plan_id, k, task.start, task.end, graph_->status(task.id), robot,
                        total, task.id, task.timestep, graph_->dependencies(task.id)});
    }
  }
  return orders;
}

std::vector<AgentId> Execution::lostRobots() const {
  std::vector<AgentId> lost;
  for (int robot = 0; robot < robotCount(); ++robot) {
    if (monitors_[index(robot)].isLost()) {
      lost.push_back(robot);
    }
  }
  return lost;
}

bool Execution::isUnderWay() const {
  return graph_ && (phase_ == ExecutionPhase::Executing || phase_ == ExecutionPhase::Cutting ||
                    phase_ == ExecutionPhase::AtCut);
}

bool Execution::hasReleased(int robot) const {
  return graph_ && graph_->doneCount(robot) < graph_->releasedCount(robot);
}

int Execution::releasedCount(int robot) const {
  return graph_->releasedCount(robot) - firstSequence(robot);
}

TaskId Execution::taskOf(int robot, int sequence) const {
  if (!graph_ || robot < 0 || robot >= robotCount()) {
    throw std::invalid_argument("the event names a task before there is a plan");
  }
  const std::vector<TaskId>& tasks = graph_->tasksOf(robot);
  const int k = firstSequence(robot) + sequence;
  if (sequence < 0 || k >= static_cast<int>(tasks.size())) {
    throw std::invalid_argument("the event names a task that the plan does not have");
  }
  return tasks[index(k)];
}

}  // namespace sylph
