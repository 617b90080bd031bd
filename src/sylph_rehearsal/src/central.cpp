#include "central.hpp"

#include <utility>

#include "sylph_core/adg/explanation.hpp"
#include "sylph_core/execution/event_line.hpp"

namespace sylph_rehearsal {
namespace {

/// AdgState on change, but not more often than this [s].
constexpr double kShortestStatePeriod_s = 0.02;

}  // namespace

Central::Central(const sylph::Experiment& experiment, sylph::ExecutionLimits limits,
                 double heartbeat_period_s, EventQueue& queue, Ports ports)
    : experiment_(&experiment),
      limits_(std::move(limits)),
      heartbeat_period_s_(heartbeat_period_s),
      queue_(&queue),
      ports_(std::move(ports)),
      names_(namesOf(experiment)) {}

void Central::start() {
  ++life_;
  execution_.emplace(names_, experiment_->grid.rows(), experiment_->grid.cols(),
                     experiment_->cell_size_m, limits_, experiment_->corner);
  for (const std::string& line : log_) {
    execution_->replay(sylph::eventFromLine(line, names_).event);
  }
  has_changed_ = true;
  tick(life_);
}

void Central::crash() {
  ++life_;
  execution_.reset();
}

void Central::launchAnew() {
  crash();
  log_.clear();
  start();
}

void Central::tick(int life) {
  if (life != life_) {
    return;
  }
  execution_->tick(queue_->now());
  flush();
  if (queue_->now() - state_sent_s_ >= heartbeat_period_s_ / 2.0) {
    publishCentralState();
  }
  ports_.adg_state(explain(*execution_, queue_->now()));
  queue_->after(heartbeat_period_s_, [this, life] { tick(life); });
}

void Central::onPlan(const sylph::MissionPlan& plan) {
  if (execution_) {
    execution_->submit(plan, queue_->now());
    flush();
  }
}

void Central::onReport(int robot, const sylph::RobotReport& report) {
  if (execution_) {
    execution_->report(robot, report, queue_->now());
    record_.addTrackingError(report.tracking_error_m);
    flush();
  }
}

void Central::onEmergencyStop(bool is_pressed, const std::string& reason) {
  if (execution_) {
    execution_->setEmergencyStop(is_pressed, reason);
    flush();
  }
}

bool Central::setMode(sylph::ExecutionMode mode, const std::string& reason) {
  if (!execution_ || !execution_->setMode(mode, reason)) {
    return false;
  }
  flush();
  return true;
}

void Central::declareLost(int robot, const std::string& reason) {
  if (execution_) {
    execution_->declareLost(robot, reason);
    flush();
  }
}

void Central::flush() {
  const double now_s = queue_->now();
  const std::vector<sylph::ExecutionEvent> events = execution_->takeEvents();
  for (const sylph::ExecutionEvent& event : events) {
    log_.push_back(sylph::toLine({now_s, event}, names_));
    record_.add({now_s, event});
    ports_.event(event);
  }
  for (const sylph::TaskOrder& order : execution_->takeOrders(now_s)) {
    ports_.task(order);
  }
  has_changed_ = has_changed_ || !events.empty();
  if (has_changed_ && now_s - state_sent_s_ >= kShortestStatePeriod_s) {
    publishCentralState();
  }
}

bool Central::hasTasksToCome(int robot) const {
  return execution_ && execution_->missionGoals().count(robot) > 0 &&
         execution_->graph()->currentTask(robot).has_value();
}

void Central::publishCentralState() {
  has_changed_ = false;
  state_sent_s_ = queue_->now();
  ports_.central_state({execution_->mode(), execution_->executedPlanId(), queue_->now()});
}

}  // namespace sylph_rehearsal
