#include "sylph_core/control/robot_controller.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sylph_core/control/time_jump.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

// Between two poses the velocity counts as constant.
constexpr double kLongestStretch_s = 0.03;

/// How far a point lies outside a cell; 0 inside [m].
double distanceOutside(const CellFrame& frame, const Cell& cell, const Point& point) {
  const Point center = frame.toPoint(cell);
  const double half_m = frame.cellSize() / 2.0;
  return std::hypot(std::max(0.0, std::abs(point.x - center.x) - half_m),
                    std::max(0.0, std::abs(point.y - center.y) - half_m));
}

}  // namespace

RobotController::RobotController(const RobotControllerOptions& options, const Grid& grid,
                                 const CellFrame& frame)
    : options_(options),
      frame_(frame),
      tasks_(grid),
      watch_(options.watch),
      motion_(options.motion),
      predictor_(options.base),
      slip_(options.slip),
      follower_(options.follower),
      limiter_(options.limits) {
  if (!(options.period_s > 0.0 && options.stop_deceleration_mps2 > 0.0 &&
        options.cell_margin_m >= 0.0 && options.arrival_poses > 0)) {
    throw std::invalid_argument(
        "robot controller: period, stop deceleration and arrival poses must be > 0");
  }
}

TaskAnswer RobotController::onTask(const TaskOrder& task, double now_s) {
  TaskAnswer answer = tasks_.offer(task, whereabouts(now_s));
  if (answer.verdict == TaskVerdict::Accepted) {
    refusal_.clear();
    followTasks();
  } else if (answer.verdict == TaskVerdict::Refused) {
    refusal_ = answer.reason;
  }
  return answer;
}

void RobotController::followTasks() {
  // Tasks that are told to be done at once only move the begin of the path.
  const bool has_only_done = follower_.path().legCount() == 0 && first_task_ < tasks_.done();
  const bool starts_anew = followed_plan_ != tasks_.planId() || has_only_done;
  if (starts_anew) {
    alignment_.reset();
    followed_plan_ = tasks_.planId();
    first_task_ = tasks_.done();
    arrival_poses_ = 0;
    finish_waypoint_.reset();
    follower_.reset(frame_.toPoint(tasks_.heldCells().front()));
  }
  for (int next = first_task_ + follower_.path().legCount(); next < tasks_.accepted(); ++next) {
    follower_.append(frame_.toPoint(tasks_.tasks()[static_cast<std::size_t>(next)].end));
  }
}

PoseVerdict RobotController::onPose(const TimedPose& pose) {
  const std::optional<TimedPose> before = watch_.last();
  if (!isDriven() && !central_.has_tasks_to_come && watch_.mayBeCarried()) {
    watch_.confirm();  // it has not driven and is not about to: it was put there
  }
  const std::optional<TimedPose> seen = watch_.seen();
  const Pose2d driven = drivenUntil(pose);
  const PoseVerdict verdict = watch_.offer(pose, driven);
  predictor_.forgetBefore(watch_.seen() ? watch_.seen()->captured_s : pose.captured_s);
  if (verdict != PoseVerdict::Good || watch_.problem(pose.received_s)) {
    arrival_poses_ = 0;
    return verdict;
  }
  const Twist2d twist_map =
      predictor_.predict(pose.pose, pose.captured_s, pose.captured_s).twist_map;
  if (seen) {
    watchMotion(*seen, pose, driven);
  }
  if (before) {
    learnSlip(*before, pose, twist_map);
  }
  detectArrival(pose.pose, twist_map);
  return verdict;
}

Pose2d RobotController::drivenUntil(const TimedPose& pose) const {
  if (!watch_.seen()) {
    return pose.pose;
  }
  const TimedPose& seen = *watch_.seen();
  return predictor_.predict(seen.pose, seen.captured_s, pose.captured_s).pose;
}

void RobotController::watchMotion(const TimedPose& before, const TimedPose& now,
                                  const Pose2d& driven) {
  const double duration_s = now.captured_s - before.captured_s;
  const bool is_driven = isDriven() && decision_.permission != Permission::Stop;
  if (!is_driven || duration_s <= 0.0 || duration_s > options_.watch.timeout_s) {
    motion_.pause();
    return;
  }
  const Point from = position(before.pose);
  motion_.offer(displacement(from, position(driven)), displacement(from, position(now.pose)),
                duration_s);
}

void RobotController::learnSlip(const TimedPose& before, const TimedPose& now,
                                const Twist2d& model_map) {
  const double duration_s = now.stamp_s - before.stamp_s;
  if (duration_s <= 0.0 || duration_s > kLongestStretch_s) {
    return;
  }
  const Twist2d measured_map{(now.pose.x_m - before.pose.x_m) / duration_s,
                             (now.pose.y_m - before.pose.y_m) / duration_s, 0.0};
  const Twist2d measured = robotFromMap(measured_map, now.pose.yaw_rad);
  // The model is told what was wanted; the base was told that, compensated.
  const Twist2d sent = slip_.compensate(robotFromMap(model_map, now.pose.yaw_rad));
  slip_.learn({sent.x_mps * duration_s, sent.y_mps * duration_s},
              {measured.x_mps * duration_s, measured.y_mps * duration_s}, duration_s);
}

void RobotController::detectArrival(const Pose2d& pose, const Twist2d& twist_map) {
  const Vector2 velocity_map{twist_map.x_mps, twist_map.y_mps};
  bool has_arrived = false;
  if (alignment_) {
    has_arrived = isAtRestIn(alignment_->target(), pose, velocity_map,
                             options_.follower.heading_rad, options_.arrival);
  } else if (!tasks_.isIdle()) {
    has_arrived = hasArrived(follower_.path(), reachedWaypoint(), pose, velocity_map,
                             options_.follower.heading_rad, options_.arrival);
  }
  arrival_poses_ = has_arrived ? arrival_poses_ + 1 : 0;
  const bool is_shown = arrival_poses_ >= options_.arrival_poses;
  if (alignment_) {
    has_aligned_ = is_shown;
  } else if (is_shown) {
    arrival_poses_ = 0;
    tasks_.completeCurrent();
  }
}

void RobotController::followAlignment(double now_s) {
  if (!central_.is_aligning) {
    alignment_.reset();
    return;
  }
  if (alignment_ || !tasks_.isIdle() || watch_.problem(now_s)) {
    return;
  }
  const Pose2d& here = watch_.last()->pose;
  alignment_.emplace(frame_.toPoint(frame_.toCell(position(here))), here,
                     options_.follower.heading_rad, options_.follower.heading_tolerance_rad);
  has_aligned_ = false;
  arrival_poses_ = 0;
  // What it has driven before is over: it rests where it is aligned to until tasks come.
  followed_plan_ = 0;
  first_task_ = tasks_.done();
  finish_waypoint_.reset();
  follower_.reset(alignment_->target());
}

void RobotController::onCentralState(const CentralState& state, double now_s) {
  const bool is_late = central_heard_s_ && state.stamp_s < central_.stamp_s &&
                       state.stamp_s > central_.stamp_s - kTimeJump_s;
  if (is_late) {
    return;
  }
  central_ = state;
  central_heard_s_ = now_s;
  emergency_.onCentralMode(state.mode);
  followAlignment(now_s);
}

PoseConfirmation RobotController::confirmPose(double now_s) {
  if (!central_heard_s_ || central_.mode != ExecutionMode::Stop) {
    return {false, "stop first: a robot whose pose is confirmed may drive on at once"};
  }
  if (const std::optional<Pose2d> place = watch_.placeToConfirm()) {
    watch_.confirm();
    motion_.confirm();
    return {true, format("its pose is confirmed: %.3f m, ", place->x_m) +
                      format("%.3f m, ", place->y_m) +
                      format("%.0f deg, in ", place->yaw_rad * 180.0 / M_PI) +
                      toString(frame_.toCell(position(*place)))};
  }
  if (const std::optional<std::string> problem = watch_.problem(now_s)) {
    return {false, "there is no pose to confirm: " + *problem};
  }
  if (motion_.problem()) {
    motion_.confirm();
    return {true, "it is confirmed that its pose moves as it is driven"};
  }
  return {false, "nothing is wrong with its pose"};
}

bool RobotController::isDisplaced() const {
  const std::vector<Cell> held = tasks_.heldCells();
  if (held.empty() || !watch_.last()) {
    return false;
  }
  const Point here = position(watch_.last()->pose);
  return std::all_of(held.begin(), held.end(), [this, &here](const Cell& cell) {
    return distanceOutside(frame_, cell, here) > options_.cell_margin_m;
  });
}

bool RobotController::hasOtherPlansTasks() const {
  return !tasks_.isIdle() && central_.executed_plan_id != tasks_.planId();
}

Whereabouts RobotController::whereabouts(double now_s) const {
  if (watch_.problem(now_s)) {
    return {};
  }
  return {frame_.toCell(position(watch_.last()->pose)), isDisplaced() || hasOtherPlansTasks()};
}

RobotSituation RobotController::situation(double now_s) const {
  RobotSituation situation;
  situation.pose_problem = watch_.problem(now_s);
  situation.motion_problem =
      alignment_ && alignment_->problem() ? alignment_->problem() : motion_.problem();
  situation.has_task = !tasks_.isIdle();
  situation.is_aligning = alignment_.has_value();
  situation.has_aligned = has_aligned_;
  situation.has_finished_last_task = finish_waypoint_ && reachedWaypoint() >= *finish_waypoint_;
  if (central_heard_s_) {
    situation.central_silence_s = now_s - *central_heard_s_;
  }
  situation.mode = central_.mode;
  if (hasOtherPlansTasks()) {
    situation.other_plan_id = tasks_.planId();
  }
  situation.is_emergency = emergency_.isActive();
  situation.is_displaced = isDisplaced();
  if (watch_.last()) {
    situation.heading_error_rad =
        shortestAngle(watch_.last()->pose.yaw_rad, options_.follower.heading_rad);
  }
  return situation;
}

int RobotController::lastWaypoint(Permission permission) {
  if (permission != Permission::FinishTask) {
    finish_waypoint_.reset();
    return tasks_.accepted() - first_task_;
  }
  if (!finish_waypoint_) {
    finish_waypoint_ = std::max(reachedWaypoint() + 1, follower_.firstStop());
  }
  return *finish_waypoint_;
}

double RobotController::stepTo(double now_s) {
  const double step_s = updated_s_ ? now_s - *updated_s_ : options_.period_s;
  updated_s_ = now_s;
  return std::clamp(step_s, 0.2 * options_.period_s, 5.0 * options_.period_s);
}

Twist2d RobotController::update(double now_s) {
  const double step_s = stepTo(now_s);
  watch_.commanded(speed(limiter_.last()) * step_s);
  decision_ = decide(situation(now_s), options_.supervisor);
  if (decision_.permission == Permission::Stop || !isDriven()) {
    follower_.halt();
    return noteCommand(limiter_.ramp(options_.stop_deceleration_mps2, step_s), now_s);
  }
  const TimedPose& pose = *watch_.last();
  const MotionState state =
      predictor_.predict(pose.pose, pose.captured_s, now_s + options_.base.latency_s);
  Twist2d wanted =
      follower_.update(state, reachedWaypoint(), lastWaypoint(decision_.permission), step_s);
  if (const double wanted_mps = speed(wanted);
      motion_.isUnanswered() && wanted_mps > options_.motion.creep_mps) {
    wanted.x_mps *= options_.motion.creep_mps / wanted_mps;
    wanted.y_mps *= options_.motion.creep_mps / wanted_mps;
  }
  if (alignment_) {
    wanted = alignment_->limit(wanted, pose.pose, step_s);
  }
  return noteCommand(limiter_.limit(wanted, step_s), now_s);
}

Twist2d RobotController::rampDown(double now_s) {
  follower_.halt();
  return noteCommand(limiter_.ramp(options_.stop_deceleration_mps2, stepTo(now_s)), now_s);
}

Twist2d RobotController::noteCommand(const Twist2d& command_map, double now_s) {
  predictor_.command(now_s, command_map);
  const double yaw_rad = watch_.last() ? watch_.last()->pose.yaw_rad : 0.0;
  return slip_.compensate(robotFromMap(command_map, yaw_rad));
}

RobotReport RobotController::report(double now_s) const {
  RobotReport report;
  report.plan_id = tasks_.planId();
  report.accepted = tasks_.accepted();
  report.done = tasks_.done();
  report.state = decision_.state;
  report.detail = decision_.detail;
  if (report.detail.empty() && !refusal_.empty()) {
    report.detail = "refuses " + refusal_;
  }
  report.pose_age_s = watch_.age(now_s);
  if (watch_.last()) {
    report.pose = watch_.last()->pose;
    report.heading_error_rad = shortestAngle(options_.follower.heading_rad, report.pose->yaw_rad);
    if (follower_.path().legCount() > 0) {
      // The leg before counts too: an arrival is reported a little before its end.
      report.tracking_error_m = distanceToRest(follower_.path(), std::max(0, reachedWaypoint() - 1),
                                               position(*report.pose));
    }
  }
  return report;
}

}  // namespace sylph
