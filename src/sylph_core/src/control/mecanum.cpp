#include "sylph_core/control/mecanum.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace sylph {
namespace {

void requireLength(const char* name, double value_m) {
  if (!std::isfinite(value_m) || value_m <= 0.0) {
    throw std::invalid_argument(std::string("mecanum ") + name + " " + std::to_string(value_m) +
                                " m: must be > 0");
  }
}

}  // namespace

MecanumKinematics::MecanumKinematics(const MecanumGeometry& geometry)
    : radius_m_(geometry.wheel_radius_m),
      lever_m_(geometry.half_wheelbase_m + geometry.half_track_m) {
  requireLength("wheel_radius_m", geometry.wheel_radius_m);
  requireLength("half_wheelbase_m", geometry.half_wheelbase_m);
  requireLength("half_track_m", geometry.half_track_m);
}

WheelSpeeds MecanumKinematics::toWheels(const Twist2d& twist_robot) const {
  const double x = twist_robot.x_mps;
  const double y = twist_robot.y_mps;
  const double turn = lever_m_ * twist_robot.turn_radps;
  // Rollers at 45 degrees, in an X as seen from above: a wheel rolls at its own speed forward, give
  // or take that sideways.
  return {(x - y - turn) / radius_m_, (x + y + turn) / radius_m_, (x + y - turn) / radius_m_,
          (x - y + turn) / radius_m_};
}

Twist2d MecanumKinematics::toTwist(const WheelSpeeds& wheels) const {
  const double fl = wheels.front_left_radps;
  const double fr = wheels.front_right_radps;
  const double rl = wheels.rear_left_radps;
  const double rr = wheels.rear_right_radps;
  // Four wheels tell three numbers: least squares, which slip of a single wheel spoils the least.
  const double quarter_m = radius_m_ / 4.0;
  return {quarter_m * (fl + fr + rl + rr), quarter_m * (-fl + fr + rl - rr),
          quarter_m / lever_m_ * (-fl + fr - rl + rr)};
}

Twist2d MecanumKinematics::limitWheels(const Twist2d& twist_robot, double limit_radps) const {
  if (!(limit_radps > 0.0)) {
    throw std::invalid_argument("wheel speed limit " + std::to_string(limit_radps) +
                                " rad/s: must be > 0");
  }
  const WheelSpeeds wheels = toWheels(twist_robot);
  const double fastest =
      std::max({std::abs(wheels.front_left_radps), std::abs(wheels.front_right_radps),
                std::abs(wheels.rear_left_radps), std::abs(wheels.rear_right_radps)});
  if (fastest <= limit_radps) {
    return twist_robot;
  }
  // All by one factor, so that the robot gets slower and keeps its direction.
  const double factor = limit_radps / fastest;
  return {factor * twist_robot.x_mps, factor * twist_robot.y_mps, factor * twist_robot.turn_radps};
}

}  // namespace sylph
