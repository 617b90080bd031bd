#include "robot.hpp"

#include <cmath>

namespace sylph_rehearsal {
namespace {

/// An operator sees that a robot is farther than this from where it is shown.
constexpr double kSeenApart_m = 0.03;
constexpr double kSeenApart_rad = 0.2;

}  // namespace

void Robot::start() {
  ++life_;
  node_.emplace(Node{sylph::RobotController(setup_->controller, setup_->grid, setup_->frame),
                     sylph::RobotReporter(setup_->report_rate_hz)});
  tick(life_);
}

void Robot::crash() {
  ++life_;
  node_.reset();
}

void Robot::tick(int life) {
  if (life != life_) {
    return;
  }
  ports_.command(node_->controller.update(queue_->now()));
  report();
  queue_->after(setup_->controller.period_s, [this, life] { tick(life); });
}

void Robot::onTask(const sylph::TaskOrder& task) {
  if (node_) {
    node_->controller.onTask(task, queue_->now());
    report();
  }
}

void Robot::onPose(const sylph::Pose2d& pose, double stamp_s) {
  if (node_) {
    const double age_s = queue_->now() + clock_offset_s_ - stamp_s;
    node_->controller.onPose(sylph::timedPose(pose, stamp_s, age_s, queue_->now()));
    report();
  }
}

void Robot::onCentralState(const sylph::CentralState& state) {
  if (node_) {
    node_->controller.onCentralState(state, queue_->now());
  }
}

void Robot::onEmergencyStop(bool is_pressed) {
  if (node_) {
    node_->controller.onEmergencyStop(is_pressed);
  }
}

void Robot::onLookedAt(const sylph::Pose2d& truth) {
  if (!node_) {
    return;
  }
  const double now_s = queue_->now();
  std::optional<sylph::Pose2d> shown = node_->controller.placeToConfirm();
  if (!shown) {
    shown = node_->controller.report(now_s).pose;
  }
  if (shown && distance(position(*shown), position(truth)) < kSeenApart_m &&
      std::abs(sylph::shortestAngle(shown->yaw_rad, truth.yaw_rad)) < kSeenApart_rad) {
    node_->controller.confirmPose(now_s);
  }
}

void Robot::report() {
  const double now_s = queue_->now();
  if (auto report = node_->reporter.offer(node_->controller.report(now_s), now_s)) {
    report->stamp_s = now_s + clock_offset_s_;
    ports_.report(*report);
  }
}

}  // namespace sylph_rehearsal
