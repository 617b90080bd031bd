#include "sylph_core/control/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace sylph {
namespace {

// Closer to a stop than the first the robot rests, until it is farther off than the second.
constexpr double kRestWithin_m = 0.002;
constexpr double kLeaveRestBeyond_m = 0.004;

void requireWithin(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(std::string("path following: ") + name + " " +
                                std::to_string(value) + ": must be " + std::to_string(low) +
                                " ... " + std::to_string(high));
  }
}

Vector2 velocity(const MotionState& state) {
  return {state.twist_map.x_mps, state.twist_map.y_mps};
}

}  // namespace

PathFollower::PathFollower(const FollowerOptions& options)
    : options_(options),
      braking_mps2_(options.braking_share * options.acceleration_limit_mps2),
      approach_m_(braking_mps2_ / (options.approach_gain * options.approach_gain)),
      cross_(options.cross),
      heading_(options.heading) {
  requireWithin("speed_limit_mps", options.speed_limit_mps, 1e-3, 10.0);
  requireWithin("acceleration_limit_mps2", options.acceleration_limit_mps2, 1e-3, 100.0);
  requireWithin("braking_share", options.braking_share, 0.1, 1.0);
  requireWithin("blend_m", options.blend_m, 0.0, 1.0);
  requireWithin("approach_gain", options.approach_gain, 0.1, 50.0);
  requireWithin("lag_s", options.lag_s, 0.0, 1.0);
  requireWithin("heading_tolerance_rad", options.heading_tolerance_rad, 1e-3, M_PI);
  requireWithin("tracking_error_m", options.tracking_error_m, 1e-4, 1.0);
}

void PathFollower::reset(const Point& start) {
  path_ = DrivePath(start);
  leg_ = 0;
  is_in_blend_ = false;
  halt();
}

void PathFollower::append(const Point& waypoint) {
  const bool is_on_last_leg = leg_ + 1 >= path_.legCount();
  // A robot that is about to stop there may be too near by now to begin the whole blend.
  const double room_m = is_on_last_leg ? 0.9 * to_waypoint_m_ : options_.blend_m;
  path_.append(waypoint, std::clamp(room_m, 0.0, options_.blend_m));
}

void PathFollower::halt() {
  speed_mps_ = 0.0;
  is_halted_ = true;
  is_at_rest_ = false;
  cross_.reset();
  heading_.reset();
}

int PathFollower::firstStop() const {
  // A tenth off: a robot that brakes as planned is always just about able to, and noise must not
  // send it one cell further.
  const double needed_m = 0.9 * speed_mps_ * speed_mps_ / (2.0 * braking_mps2_);
  const bool can_stop = !is_in_blend_ && to_waypoint_m_ >= needed_m;
  return std::min(leg_ + (can_stop ? 1 : 2), path_.legCount());
}

Twist2d PathFollower::update(const MotionState& state, int reached, int last, double dt_s) {
  const Point here = position(state.pose);
  last = std::min(last, path_.legCount());
  advance(here, reached, last);
  const double heading_error_rad = shortestAngle(state.pose.yaw_rad, options_.heading_rad);
  const double turn_radps = heading_.update(heading_error_rad, -heading_error_rad, dt_s);

  Vector2 command;
  if (last <= leg_) {
    command = approach(path_.waypoint(leg_), state, dt_s);
  } else {
    const Guide guide = is_in_blend_ ? blendGuide(here) : legGuide(here);
    to_waypoint_m_ = guide.to_waypoint_m;
    const bool is_close = stopsAt(leg_ + 1, last) && guide.to_waypoint_m < approach_m_ &&
                          norm(guide.correction) < options_.tracking_error_m;
    if (is_close && !is_in_blend_) {
      command = approach(path_.waypoint(leg_ + 1), state, dt_s);
    } else {
      is_at_rest_ = false;
      command = along(guide, state, last, dt_s) + across(guide, dt_s);
    }
  }
  is_halted_ = false;
  return {command.x, command.y, turn_radps};
}

bool PathFollower::stopsAt(int waypoint, int last) const {
  return waypoint >= last || path_.corner(waypoint) == Corner::Stop;
}

void PathFollower::advance(const Point& position, int reached, int last) {
  while (leg_ + 1 < last) {
    const int waypoint = leg_ + 1;
    const Corner corner = path_.corner(waypoint);
    const Guide guide = legGuide(position);
    bool passes = false;
    if (corner == Corner::Blend) {
      is_in_blend_ = is_in_blend_ || guide.to_waypoint_m <= path_.blend(waypoint);
      passes = is_in_blend_ && blendGuide(position).to_waypoint_m <= 0.0;
    } else {
      passes = corner == Corner::Straight ? guide.to_waypoint_m <= 0.0 : reached >= waypoint;
    }
    if (!passes) {
      return;
    }
    is_in_blend_ = false;
    ++leg_;
    if (corner != Corner::Straight) {
      cross_.reset();
    }
    if (corner == Corner::Stop) {
      is_halted_ = true;
    }
  }
}

PathFollower::Guide PathFollower::legGuide(const Point& position) const {
  const Leg& leg = path_.leg(leg_);
  const Vector2 offset = displacement(leg.start, position);
  const double progress_m = dot(offset, leg.direction);
  Guide guide;
  guide.tangent = leg.direction;
  guide.correction = progress_m * leg.direction - offset;
  guide.to_waypoint_m = leg.length_m - progress_m;
  return guide;
}

PathFollower::Guide PathFollower::blendGuide(const Point& position) const {
  const int waypoint = leg_ + 1;
  const Vector2 in = path_.leg(leg_).direction;
  const Vector2 out = path_.leg(waypoint).direction;
  const double blend_m = path_.blend(waypoint);
  const Vector2 offset = displacement(path_.waypoint(waypoint), position);
  // Progress along the chord from the begin of the parabola to its end, which is 2 D cos(turn / 2).
  const Vector2 chord = in + out;
  const double chord_norm = norm(chord);
  const double s = 0.5 + dot(offset, chord) / (blend_m * chord_norm * chord_norm);
  const double inside = std::clamp(s, 0.0, 1.0);

  Guide guide;
  const Vector2 rate = (1.0 - inside) * in + inside * out;
  guide.scale = norm(rate);
  guide.tangent = (1.0 / guide.scale) * rate;
  const Vector2 closest =
      (-blend_m * (1.0 - inside) * (1.0 - inside)) * in + (blend_m * inside * inside) * out;
  guide.correction = closest - offset;
  guide.blend_speed_mps = path_.blendSpeed(waypoint, options_.acceleration_limit_mps2);
  guide.bend_mps2 = (guide.blend_speed_mps * guide.blend_speed_mps / (2.0 * blend_m)) * (out - in);
  guide.to_waypoint_m = (1.0 - s) * 2.0 * blend_m;
  return guide;
}

PathFollower::SpeedLimit PathFollower::speedBefore(double allowed_mps, double distance_m) const {
  if (allowed_mps > 0.0) {
    const double speed_mps =
        std::sqrt(allowed_mps * allowed_mps + 2.0 * braking_mps2_ * std::max(0.0, distance_m));
    return {speed_mps, distance_m > 0.0 ? braking_mps2_ / speed_mps : 0.0};
  }
  if (distance_m <= approach_m_) {
    return {options_.approach_gain * distance_m, options_.approach_gain};
  }
  const double speed_mps = std::sqrt(2.0 * braking_mps2_ * (distance_m - approach_m_ / 2.0));
  return {speed_mps, braking_mps2_ / speed_mps};
}

PathFollower::SpeedLimit PathFollower::speedLimit(const Guide& guide, int last) const {
  SpeedLimit limit{options_.speed_limit_mps, 0.0};
  const auto apply = [&limit](const SpeedLimit& other) {
    if (other.speed_mps < limit.speed_mps) {
      limit = other;
    }
  };
  double distance_m = guide.to_waypoint_m;
  int waypoint = leg_ + 1;
  if (is_in_blend_) {
    apply({guide.blend_speed_mps, 0.0});
    distance_m += path_.leg(waypoint).length_m - path_.blend(waypoint);
    ++waypoint;
  }
  const double horizon_m =
      options_.speed_limit_mps * options_.speed_limit_mps / (2.0 * braking_mps2_) + approach_m_;
  while (distance_m - options_.blend_m < horizon_m) {
    if (stopsAt(waypoint, last)) {
      apply(speedBefore(0.0, distance_m));
      break;
    }
    if (path_.corner(waypoint) == Corner::Blend) {
      apply(speedBefore(path_.blendSpeed(waypoint, options_.acceleration_limit_mps2),
                        distance_m - path_.blend(waypoint)));
    }
    distance_m += path_.leg(waypoint).length_m;
    ++waypoint;
  }
  return limit;
}

Vector2 PathFollower::along(const Guide& guide, const MotionState& state, int last, double dt_s) {
  const double measured_mps = dot(velocity(state), guide.tangent);
  if (is_halted_) {
    speed_mps_ = std::clamp(measured_mps, 0.0, options_.speed_limit_mps);
  }
  const double before_mps = speed_mps_;
  const SpeedLimit limit = speedLimit(guide, last);
  const bool is_off = norm(guide.correction) > options_.tracking_error_m ||
                      std::abs(shortestAngle(state.pose.yaw_rad, options_.heading_rad)) >
                          options_.heading_tolerance_rad;
  double change_mps2 = 0.0;
  if (is_off) {
    speed_mps_ = std::max(0.0, before_mps - braking_mps2_ * dt_s);
    change_mps2 = (speed_mps_ - before_mps) / dt_s;
  } else if (before_mps + options_.acceleration_limit_mps2 * dt_s < limit.speed_mps) {
    speed_mps_ = before_mps + options_.acceleration_limit_mps2 * dt_s;
    change_mps2 = options_.acceleration_limit_mps2;
  } else {
    speed_mps_ = limit.speed_mps;
    change_mps2 = -limit.slope_per_s * measured_mps;
  }
  const double share = guide.blend_speed_mps > 0.0 ? speed_mps_ / guide.blend_speed_mps : 0.0;
  const Vector2 bend_mps2 = (share * share) * guide.bend_mps2;
  return (guide.scale * (speed_mps_ + options_.lag_s * change_mps2)) * guide.tangent +
         options_.lag_s * bend_mps2;
}

Vector2 PathFollower::across(const Guide& guide, double dt_s) {
  if (is_in_blend_) {
    return options_.cross.proportional * guide.correction;
  }
  const Vector2 left{-guide.tangent.y, guide.tangent.x};
  const double error_m = dot(guide.correction, left);
  return cross_.update(error_m, -error_m, dt_s) * left;
}

Vector2 PathFollower::approach(const Point& target, const MotionState& state, double dt_s) {
  const Vector2 way = displacement(position(state.pose), target);
  const double distance_m = norm(way);
  is_at_rest_ = distance_m < (is_at_rest_ ? kLeaveRestBeyond_m : kRestWithin_m);
  if (is_at_rest_) {
    speed_mps_ = 0.0;
    return {};
  }
  if (is_halted_) {
    speed_mps_ = std::max(0.0, dot(velocity(state), way) / distance_m);
  }
  const SpeedLimit limit = speedBefore(0.0, distance_m);
  speed_mps_ = std::min({speed_mps_ + options_.acceleration_limit_mps2 * dt_s, limit.speed_mps,
                         options_.speed_limit_mps});
  const double damping = speed_mps_ < limit.speed_mps ? 0.0 : options_.lag_s * limit.slope_per_s;
  return (speed_mps_ / distance_m) * way - damping * velocity(state);
}

}  // namespace sylph
