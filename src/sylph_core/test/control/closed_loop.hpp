#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "sylph_core/control/arrival.hpp"
#include "sylph_core/control/path_follower.hpp"
#include "sylph_core/control/pose_predictor.hpp"
#include "sylph_core/control/twist_limiter.hpp"
#include "sylph_core/grid/rng.hpp"

namespace sylph {

/// A robot as it is, for tests of the controller.
struct PlantOptions {
  double command_delay_s = 0.04;
  double camera_delay_s = 0.01;
  double lag_s = 0.1;
  double noise_m = 0.0002;
  double yaw_noise_rad = 0.001;
  double forward_gain = 0.98;  ///< of the commanded speed, along the robot
  double sideways_gain = 0.95;
  double drift_rad = 0.01;  ///< by which its motion is turned against the command
  double resolution_mps = 0.001;
};

/// What one drive along a path showed.
struct DriveRecord {
  bool finished = false;
  double time_s = 0.0;               ///< until the last leg was done
  double largest_error_m = 0.0;      ///< true distance from the legs
  double largest_overshoot_m = 0.0;  ///< true distance beyond the end of the path
  double largest_speed_mps = 0.0;
  double largest_acceleration_mps2 = 0.0;
  double largest_heading_error_rad = 0.0;
  std::vector<double> done_s;  ///< when each leg was done
};

/// Controller and plant in simulated time: 50 Hz control, 120 Hz poses, 1 ms plant.
class ClosedLoop {
 public:
  ClosedLoop(const FollowerOptions& follower, const BaseModel& model, const PlantOptions& plant,
             const Pose2d& start, std::uint32_t seed = 1)
      : follower_(follower),
        predictor_(model),
        limiter_({follower.speed_limit_mps, 2.0, follower.heading.output_limit, 4.0}),
        model_(model),
        plant_(plant),
        pose_(start),
        captured_(start),
        rng_(seed) {
    heading_rad_ = follower.heading_rad;
    follower_.reset(position(start));
  }

  PathFollower& follower() { return follower_; }
  const Pose2d& pose() const { return pose_; }
  double time() const { return time_s_; }

  /// Drives until every leg is done and 1 s more, or until the deadline.
  /// @param release_s  when each leg is added to the path, ascending
  DriveRecord drive(const std::vector<Point>& waypoints, const std::vector<double>& release_s,
                    double deadline_s) {
    DriveRecord record;
    std::size_t released = 0;
    double stop_s = deadline_s;
    while (time_s_ < stop_s) {
      while (released < waypoints.size() && release_s[released] <= time_s_) {
        follower_.append(waypoints[released++]);
      }
      tick(record);
      observe(record);
      if (!record.finished && record.done_s.size() == waypoints.size()) {
        record.finished = true;
        record.time_s = time_s_;
        stop_s = std::min(deadline_s, time_s_ + 1.0);
      }
    }
    return record;
  }

 private:
  void tick(DriveRecord& record) {
    if (step_ % 20 == 0) {
      control();
    }
    moveBase(record);
    if (step_ % 25 == 0 || step_ % 25 == 8 || step_ % 25 == 17) {  // 120 Hz
      capture();
      detect(record);
    }
    ++step_;
    time_s_ = 0.001 * step_;
  }

  void control() {
    const MotionState state =
        predictor_.predict(captured_, captured_s_, time_s_ + model_.latency_s);
    const Twist2d wanted = follower_.update(state, reached_, follower_.path().legCount(), 0.02);
    const Twist2d command = limiter_.limit(wanted, 0.02);
    predictor_.command(time_s_, command);
    Twist2d sent = robotFromMap(command, captured_.yaw_rad);
    const double unit = plant_.resolution_mps;
    sent.x_mps = std::round(sent.x_mps / unit) * unit;
    sent.y_mps = std::round(sent.y_mps / unit) * unit;
    sent.turn_radps = std::round(sent.turn_radps / unit) * unit;
    sent_.emplace_back(time_s_ + plant_.command_delay_s, sent);
  }

  void moveBase(DriveRecord& record) {
    while (!sent_.empty() && sent_.front().first <= time_s_) {
      target_ = sent_.front().second;
      sent_.pop_front();
    }
    const double share = plant_.lag_s > 0.0 ? 1.0 - std::exp(-0.001 / plant_.lag_s) : 1.0;
    const Twist2d before = wheel_;
    wheel_.x_mps += share * (target_.x_mps - wheel_.x_mps);
    wheel_.y_mps += share * (target_.y_mps - wheel_.y_mps);
    wheel_.turn_radps += share * (target_.turn_radps - wheel_.turn_radps);
    record.largest_acceleration_mps2 =
        std::max(record.largest_acceleration_mps2,
                 std::hypot(wheel_.x_mps - before.x_mps, wheel_.y_mps - before.y_mps) / 0.001);
    Twist2d moved = wheel_;
    moved.x_mps *= plant_.forward_gain;
    moved.y_mps *= plant_.sideways_gain;
    const Twist2d twist_map = mapFromRobot(moved, pose_.yaw_rad + plant_.drift_rad);
    pose_.x_m += 0.001 * twist_map.x_mps;
    pose_.y_m += 0.001 * twist_map.y_mps;
    pose_.yaw_rad = normalizeAngle(pose_.yaw_rad + 0.001 * twist_map.turn_radps);
    record.largest_speed_mps = std::max(record.largest_speed_mps, speed(twist_map));
  }

  void capture() {
    Pose2d seen = pose_;
    seen.x_m += plant_.noise_m * drawNormal(rng_);
    seen.y_m += plant_.noise_m * drawNormal(rng_);
    seen.yaw_rad += plant_.yaw_noise_rad * drawNormal(rng_);
    seen_.emplace_back(time_s_, seen);
    while (!seen_.empty() && seen_.front().first + plant_.camera_delay_s <= time_s_) {
      captured_s_ = seen_.front().first;
      captured_ = seen_.front().second;
      seen_.pop_front();
    }
  }

  void detect(DriveRecord& record) {
    if (reached_ >= follower_.path().legCount()) {
      return;
    }
    const MotionState state = predictor_.predict(captured_, captured_s_, captured_s_);
    const Vector2 velocity{state.twist_map.x_mps, state.twist_map.y_mps};
    const bool arrived =
        hasArrived(follower_.path(), reached_, captured_, velocity, heading_rad_, {});
    frames_ = arrived ? frames_ + 1 : 0;
    if (frames_ >= 2) {
      frames_ = 0;
      ++reached_;
      record.done_s.push_back(time_s_);
    }
  }

  void observe(DriveRecord& record) {
    const DrivePath& path = follower_.path();
    if (path.legCount() == 0) {
      return;
    }
    double error_m = distanceToLeg(path.leg(0), position(pose_));
    for (int leg = 1; leg < path.legCount(); ++leg) {
      error_m = std::min(error_m, distanceToLeg(path.leg(leg), position(pose_)));
    }
    record.largest_error_m = std::max(record.largest_error_m, error_m);
    record.largest_heading_error_rad =
        std::max(record.largest_heading_error_rad, std::abs(pose_.yaw_rad - heading_rad_));
    const Leg& last = path.leg(path.legCount() - 1);
    record.largest_overshoot_m = std::max(
        record.largest_overshoot_m, dot(displacement(last.end, position(pose_)), last.direction));
  }

  PathFollower follower_;
  PosePredictor predictor_;
  TwistLimiter limiter_;
  BaseModel model_;
  PlantOptions plant_;
  Pose2d pose_;
  Pose2d captured_;
  Rng rng_;
  double heading_rad_ = 0.0;
  double captured_s_ = 0.0;
  double time_s_ = 0.0;
  int step_ = 0;
  int reached_ = 0;
  int frames_ = 0;
  Twist2d target_;
  Twist2d wheel_;
  std::deque<std::pair<double, Twist2d>> sent_;
  std::deque<std::pair<double, Pose2d>> seen_;
};

}  // namespace sylph
