#include "sylph_core/control/twist_limiter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sylph {

TwistLimiter::TwistLimiter(const TwistLimits& limits) : limits_(limits) {
  if (!(limits.speed_mps > 0.0 && limits.acceleration_mps2 > 0.0 && limits.turn_rate_radps > 0.0 &&
        limits.turn_acceleration_radps2 > 0.0)) {
    throw std::invalid_argument("limits of speed, turn rate and their changes: must be > 0");
  }
}

const Twist2d& TwistLimiter::limit(const Twist2d& wanted, double dt_s) {
  Twist2d target = wanted;
  // By one factor for both axes: the direction stays.
  const double wanted_speed = speed(wanted);
  if (wanted_speed > limits_.speed_mps) {
    target.x_mps *= limits_.speed_mps / wanted_speed;
    target.y_mps *= limits_.speed_mps / wanted_speed;
  }
  target.turn_radps =
      std::clamp(wanted.turn_radps, -limits_.turn_rate_radps, limits_.turn_rate_radps);
  return approach(target, limits_.acceleration_mps2, dt_s);
}

const Twist2d& TwistLimiter::ramp(double deceleration_mps2, double dt_s) {
  return approach({}, deceleration_mps2, dt_s);
}

const Twist2d& TwistLimiter::approach(const Twist2d& wanted, double acceleration_mps2,
                                      double dt_s) {
  const double dx = wanted.x_mps - last_.x_mps;
  const double dy = wanted.y_mps - last_.y_mps;
  const double change = std::hypot(dx, dy);
  const double allowed = acceleration_mps2 * dt_s;
  const double share = change > allowed ? allowed / change : 1.0;
  last_.x_mps += share * dx;
  last_.y_mps += share * dy;
  const double allowed_turn = limits_.turn_acceleration_radps2 * dt_s;
  last_.turn_radps += std::clamp(wanted.turn_radps - last_.turn_radps, -allowed_turn, allowed_turn);
  return last_;
}

}  // namespace sylph
