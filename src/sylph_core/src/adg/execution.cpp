#include "sylph_core/adg/execution.hpp"

#include <algorithm>

namespace sylph {

using Kind = ExecutionEvent::Kind;

Execution::Execution(std::vector<std::string> robots, int rows, int cols, double cell_size_m,
                     const ExecutionLimits& limits, const Point& corner)
    : names_(std::move(robots)),
      rows_(rows),
      cols_(cols),
      frame_(rows, cell_size_m, corner),
      limits_(limits),
      robots_(names_.size(), Robot{RobotMonitor(limits), 0, 0, {}, {}}) {}

std::optional<int> Execution::indexOf(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    return std::nullopt;
  }
  return static_cast<int>(found - names_.begin());
}

void Execution::setPhase(ExecutionPhase phase) {
  if (phase_ != phase) {
    phase_ = phase;
    log({Kind::Phase, plan_id_, -1, static_cast<int>(phase), toString(phase)});
  }
}

bool Execution::isNew(std::uint32_t plan_id) const {
  // After a restart a plan may be pending of which only the id is known.
  return plan_id > plan_id_ ||
         (plan_id == plan_id_ && phase_ == ExecutionPhase::Pending && !pending_);
}

void Execution::refuse(std::uint32_t plan_id, const std::string& reason) {
  if (isNew(plan_id)) {
    setRefused(plan_id, reason);
  }
}

void Execution::setRefused(std::uint32_t plan_id, const std::string& reason) {
  pending_.reset();
  plan_id_ = plan_id;
  last_plan_id_ = std::max(last_plan_id_, plan_id);
  refusal_ = "plan " + std::to_string(plan_id) + ": " + reason;
  phase_ = ExecutionPhase::Refused;
  log({Kind::Refused, plan_id, -1, 0, refusal_});
}

void Execution::setMode(ExecutionMode mode, const std::string& reason) {
  if (mode_ == mode) {
    return;
  }
  mode_ = mode;
  mode_reason_ = mode == ExecutionMode::Run ? std::string() : reason;
  log({Kind::Mode, plan_id_, -1, static_cast<int>(mode), reason});
  advance();
}

void Execution::declareLost(int robot, const std::string& reason) {
  RobotMonitor& monitor = robots_.at(index(robot)).monitor;
  if (monitor.isLost()) {
    return;
  }
  monitor.setLost();
  log({Kind::Lost, plan_id_, robot, 0, reason});
  advance();
}

void Execution::report(int robot, const RobotReport& report, double now_s) {
  Robot& reporter = robots_.at(index(robot));
  if (!reporter.monitor.accept(report, now_s)) {
    return;
  }
  last_plan_id_ = std::max(last_plan_id_, report.plan_id);
  if (graph_) {
    takeCounts(robot, report, now_s);
  }
  tryStart(now_s);
  advance();
}

void Execution::takeCounts(int robot, const RobotReport& report, double now_s) {
  Robot& reporter = robots_[index(robot)];
  const bool is_this_plan = report.plan_id == plan_->plan_id;
  const int released = releasedCount(robot);
  const int accepted = is_this_plan ? std::min(report.accepted, released) : 0;
  if (accepted < reporter.accepted) {
    // Its node was started again and has forgotten: everything is sent once more.
    std::fill(reporter.sent_s.begin(), reporter.sent_s.end(), std::nullopt);
  } else if (accepted > reporter.accepted) {
    log({Kind::Accepted, plan_->plan_id, robot, accepted, {}});
  }
  reporter.accepted = accepted;
  const int done = is_this_plan ? std::min(report.done, released) : 0;
  // Below 0 are unfinished tasks of a lost robot, of the plan before: this plan's counts say
  // nothing of them.
  for (int k = std::max(0, graph_->doneCount(robot) - reporter.first_sequence); k < done; ++k) {
    graph_->complete(graph_->tasksOf(robot).at(index(reporter.first_sequence + k)));
    reporter.monitor.noteProgress(now_s);
    log({Kind::Done, plan_->plan_id, robot, k, {}});
  }
}

void Execution::tick(double now_s) {
  updateConditions(now_s);
  tryStart(now_s);
  advance();
  updateWaits(now_s);
}

void Execution::updateConditions(double now_s) {
  for (int robot = 0; robot < robotCount(); ++robot) {
    RobotMonitor& monitor = robots_[index(robot)].monitor;
    const bool has_tasks = isUnderWay() && graph_->currentTask(robot).has_value();
    const bool should_move = has_tasks && hasReleased(robot) && mode_ != ExecutionMode::Stop;
    if (monitor.update(should_move, now_s)) {
      log({Kind::Condition, plan_id_, robot, static_cast<int>(monitor.condition()),
           monitor.trouble(now_s)});
    }
    const std::optional<double> since_s = monitor.troubleSince();
    if (limits_.lost_after_s > 0.0 && has_tasks && mode_ == ExecutionMode::Run && since_s &&
        !monitor.isLost() && now_s - *since_s > limits_.lost_after_s) {
      declareLost(robot, monitor.trouble(now_s));
    }
  }
}

void Execution::updateWaits(double now_s) {
  for (int robot = 0; graph_ && robot < robotCount(); ++robot) {
    std::optional<double>& since_s = robots_[index(robot)].waits_since_s;
    if (!isUnderWay() || !graph_->waitOf(robot)) {
      since_s.reset();
    } else if (!since_s) {
      since_s = now_s;
    }
  }
}

void Execution::advance() {
  if (!graph_ || is_abandoned_ || phase_ == ExecutionPhase::Refused) {
    return;
  }
  const std::vector<AgentId> lost = lostRobots();
  const auto isLive = [&](int robot) {
    return std::find(lost.begin(), lost.end(), robot) == lost.end();
  };
  const auto noLiveRobot = [&](const auto& predicate) {
    for (int robot = 0; robot < robotCount(); ++robot) {
      if (isLive(robot) && predicate(robot)) {
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
  if (phase_ == ExecutionPhase::Executing) {
    if (mode_ == ExecutionMode::Run) {
      for (const TaskId released : graph_->release(limits_.lookahead, lost)) {
        const Task& task = graph_->task(released);
        log({Kind::Released,
             plan_->plan_id,
             task.agent,
             task.sequence - robots_[index(task.agent)].first_sequence,
             {}});
      }
    }
    if (noLiveRobot([&](int robot) { return graph_->currentTask(robot).has_value(); })) {
      setPhase(ExecutionPhase::Finished);
    }
  }
  if (phase_ == ExecutionPhase::Cutting &&
      noLiveRobot([&](int robot) { return hasReleased(robot); })) {
    setPhase(ExecutionPhase::AtCut);
  }
}

std::vector<ExecutionEvent> Execution::takeEvents() {
  return std::exchange(events_, {});
}

std::vector<TaskOrder> Execution::takeOrders(double now_s) {
  std::vector<TaskOrder> orders;
  for (int robot = 0; graph_ && robot < robotCount(); ++robot) {
    Robot& receiver = robots_[index(robot)];
    // What a robot has is known from its reports only, so that after a restart of this end too
    // nothing is sent to a robot before it has told.
    if (receiver.monitor.isLost() || !receiver.monitor.report()) {
      continue;
    }
    const int released = releasedCount(robot);
    receiver.sent_s.resize(index(released));
    for (int k = receiver.accepted; k < released; ++k) {
      std::optional<double>& sent_s = receiver.sent_s[index(k)];
      if (sent_s && now_s - *sent_s < limits_.resend_after_s) {
        continue;
      }
      sent_s = now_s;
      const Task& task = graph_->task(graph_->tasksOf(robot)[index(receiver.first_sequence + k)]);
      const int total = static_cast<int>(graph_->tasksOf(robot).size()) - receiver.first_sequence;
      orders.push_back({plan_->plan_id, k, task.start, task.end, graph_->status(task.id), robot,
                        total, task.id, task.timestep, graph_->dependencies(task.id)});
    }
  }
  return orders;
}

TaskId Execution::taskOf(const ExecutionEvent& event) const {
  if (!graph_ || event.robot < 0 || event.robot >= robotCount()) {
    throw std::invalid_argument("the event names a task before there is a plan");
  }
  const std::vector<TaskId>& tasks = graph_->tasksOf(event.robot);
  const int sequence = robots_[index(event.robot)].first_sequence + event.number;
  if (event.number < 0 || sequence >= static_cast<int>(tasks.size())) {
    throw std::invalid_argument("the event names a task that the plan does not have");
  }
  return tasks[index(sequence)];
}

void Execution::replay(const ExecutionEvent& event) {
  last_plan_id_ = std::max(last_plan_id_, event.plan_id);
  switch (event.kind) {
    case Kind::Started:
      load(event.plan);
      break;
    case Kind::Refused:
      plan_id_ = event.plan_id;
      refusal_ = event.text;
      phase_ = ExecutionPhase::Refused;
      break;
    case Kind::Abandoned:
      is_abandoned_ = true;
      break;
    case Kind::Released: {
      const TaskId released = taskOf(event);
      graph_->enqueue(released);
      break;
    }
    case Kind::Done: {
      const TaskId done = taskOf(event);
      graph_->complete(done);
      break;
    }
    case Kind::Lost:
      robots_.at(index(event.robot)).monitor.setLost();
      break;
    case Kind::Mode:
      mode_ = static_cast<ExecutionMode>(event.number);
      mode_reason_ = mode_ == ExecutionMode::Run ? std::string() : event.text;
      break;
    case Kind::Phase:
      phase_ = static_cast<ExecutionPhase>(event.number);
      plan_id_ = event.plan_id;
      is_cut_ = is_cut_ || phase_ == ExecutionPhase::Cutting;
      break;
    case Kind::Accepted:
    case Kind::Condition:
      break;  // robots tell these themselves
  }
  events_.clear();
}

std::vector<AgentId> Execution::lostRobots() const {
  std::vector<AgentId> lost;
  for (int robot = 0; robot < robotCount(); ++robot) {
    if (robots_[index(robot)].monitor.isLost()) {
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
  return graph_->releasedCount(robot) - robots_[index(robot)].first_sequence;
}

}  // namespace sylph
