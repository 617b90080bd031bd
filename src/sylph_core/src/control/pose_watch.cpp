#include "sylph_core/control/pose_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sylph_core/geometry/segment.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

// A base may do a little more or less than it is told.
constexpr double kSpread = 0.1;
// Stamps that go back by more are of a motion capture that started again.
constexpr double kClockRestart_s = 0.5;

// Stamps of another machine may run a little ahead of this one's clock.
constexpr double kStampAhead_s = 0.05;

// A place that was just too far away is not believed because the model of the base is a little off.
constexpr double kReturn = 0.5;

// Between two poses at rest there is less.
constexpr double kMove_m = 0.005;

}  // namespace

TimedPose timedPose(const Pose2d& pose, double stamp_s, double age_s, double received_s) {
  const double true_age_s = age_s > -kStampAhead_s ? std::max(0.0, age_s) : age_s;
  return {pose, stamp_s, received_s - true_age_s, received_s};
}

PoseWatch::PoseWatch(const PoseWatchOptions& options) : options_(options) {
  const bool is_valid = options.timeout_s > 0.0 && options.speed_limit_mps > 0.0 &&
                        options.turn_rate_limit_radps > 0.0 && options.jump_m > 0.0 &&
                        options.jump_rad > 0.0 && options.frozen_m > 0.0 &&
                        options.good_poses > 0 && options.consistent_poses > 0 &&
                        options.rejected_poses > 0;
  if (!is_valid) {
    throw std::invalid_argument("pose watch: all options must be > 0");
  }
}

PoseVerdict PoseWatch::offer(const TimedPose& pose, const Pose2d& driven) {
  if (!isFinite(pose.pose)) {
    rejection_ = "pose is not finite";
    ++rejected_;
    previous_.reset();
    was_unseen_ = true;
    return PoseVerdict::NotFinite;
  }
  if (!last_) {
    take(pose);
    return PoseVerdict::Good;
  }
  const double step_s = pose.stamp_s - last_->stamp_s;
  const bool is_clock_new = step_s < -kClockRestart_s;
  if (step_s <= 0.0 && !is_clock_new) {
    return PoseVerdict::Repeated;
  }
  noteWay(pose);
  const bool was_elsewhere = other_place_ && rejected_ >= options_.rejected_poses;
  const bool is_possible = canBeAt(pose.pose, driven, was_elsewhere ? kReturn : 1.0);
  if (is_possible && !is_clock_new) {
    take(pose);
    return PoseVerdict::Good;
  }
  return reject(pose, is_possible);
}

void PoseWatch::noteWay(const TimedPose& pose) {
  if (previous_) {
    was_unseen_ = was_unseen_ || pose.captured_s - previous_->captured_s > options_.timeout_s;
    moves_ += distance(position(previous_->pose), position(pose.pose)) > kMove_m ? 1 : 0;
  }
  previous_ = pose;
}

bool PoseWatch::canBeAt(const Pose2d& pose, const Pose2d& driven, double share) const {
  const Pose2d& from = seen_->pose;
  const Vector2 way = displacement(position(from), position(driven));
  const double turn_rad = shortestAngle(from.yaw_rad, driven.yaw_rad);
  const double off_rad = std::abs(shortestAngle(driven.yaw_rad, pose.yaw_rad));
  return distanceToSegment(position(pose), position(from) + (1.0 - kSpread) * way,
                           position(from) + (1.0 + kSpread) * way) <= share * options_.jump_m &&
         off_rad <= share * options_.jump_rad + kSpread * std::abs(turn_rad);
}

bool PoseWatch::isSamePlace(const TimedPose& from, const TimedPose& to) const {
  const double step_s = to.stamp_s - from.stamp_s;
  const double moved_m = distance(position(from.pose), position(to.pose));
  const double turned_rad = std::abs(shortestAngle(from.pose.yaw_rad, to.pose.yaw_rad));
  return step_s > 0.0 &&
         moved_m <= (1.0 + kSpread) * options_.speed_limit_mps * step_s + options_.jump_m &&
         turned_rad <=
             (1.0 + kSpread) * options_.turn_rate_limit_radps * step_s + options_.jump_rad;
}

PoseVerdict PoseWatch::reject(const TimedPose& pose, bool may_be_true) {
  ++rejected_;
  rejection_ =
      format("pose jumped by %.2f m", distance(position(last_->pose), position(pose.pose))) +
      format(" and %.0f deg",
             std::abs(shortestAngle(last_->pose.yaw_rad, pose.pose.yaw_rad)) * 180.0 / M_PI);
  const bool is_same_place = other_place_ && isSamePlace(*other_place_, pose);
  consistent_ = is_same_place ? consistent_ + 1 : 1;
  is_confirmed_ = is_same_place && is_confirmed_;
  other_place_ = pose;
  if (consistent_ < options_.consistent_poses) {
    return PoseVerdict::Jumped;
  }
  if (!may_be_true && !is_confirmed_) {
    rejection_ += ": put the cameras right, or stop, look at it and confirm its pose";
    return PoseVerdict::Jumped;
  }
  take(pose);
  good_ = options_.good_poses;
  return PoseVerdict::Recovered;
}

std::optional<Pose2d> PoseWatch::placeToConfirm() const {
  if (!other_place_ || consistent_ < options_.consistent_poses) {
    return std::nullopt;
  }
  return other_place_->pose;
}

bool PoseWatch::looksFrozen(const TimedPose& pose) const {
  return last_ && last_->pose.x_m == pose.pose.x_m && last_->pose.y_m == pose.pose.y_m &&
         last_->pose.yaw_rad == pose.pose.yaw_rad;
}

void PoseWatch::take(const TimedPose& pose) {
  if (!looksFrozen(pose)) {
    unseen_travel_m_ = 0.0;
    seen_ = pose;
  }
  const bool was_blind = rejected_ >= options_.rejected_poses ||
                         (last_ && pose.received_s - last_->received_s > options_.timeout_s);
  last_ = pose;
  previous_ = pose;
  was_unseen_ = false;
  moves_ = 0;
  other_place_.reset();
  consistent_ = 0;
  is_confirmed_ = false;
  rejected_ = 0;
  good_ = was_blind ? 1 : std::min(good_ + 1, options_.good_poses);
}

void PoseWatch::commanded(double distance_m) {
  unseen_travel_m_ += distance_m;
}

double PoseWatch::age(double now_s) const {
  return last_ ? now_s - last_->captured_s : std::numeric_limits<double>::infinity();
}

std::optional<std::string> PoseWatch::problem(double now_s) const {
  if (rejected_ >= options_.rejected_poses) {
    return rejection_;
  }
  if (!last_) {
    return "no pose yet";
  }
  const double silence_s = now_s - last_->received_s;
  if (silence_s > options_.timeout_s) {
    return format("no good pose for %.2f s", silence_s);
  }
  const double age_s = age(now_s);
  if (age_s > options_.timeout_s) {
    return format("pose is %.2f s old by its stamp", age_s);
  }
  if (age_s < -options_.timeout_s) {
    return format("pose stamp is %.2f s ahead: check the clocks", -age_s);
  }
  if (unseen_travel_m_ > options_.frozen_m) {
    return "pose is frozen";
  }
  if (good_ < options_.good_poses) {
    return "waiting for good poses";
  }
  return std::nullopt;
}

}  // namespace sylph
