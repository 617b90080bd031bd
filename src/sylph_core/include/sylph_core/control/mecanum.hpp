#pragma once

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

/// A base with four mecanum wheels whose rollers form an X as seen from above.
struct MecanumGeometry {
  double wheel_radius_m = 0.03;    ///< > 0
  double half_wheelbase_m = 0.08;  ///< from the centre forward to the wheel axes, > 0
  double half_track_m = 0.085;     ///< from the centre sideways to the wheel contacts, > 0
};

/// Turn rate of each wheel [rad/s], positive when it rolls forward.
struct WheelSpeeds {
  double front_left_radps = 0.0;
  double front_right_radps = 0.0;
  double rear_left_radps = 0.0;
  double rear_right_radps = 0.0;
};

/// Kinematics of a mecanum base without slip.
///
/// With k = half_wheelbase + half_track, radius r, velocity (x, y) and turn rate w in the robot's
/// frame:
///
///     front_left  = (x - y - k w) / r        x = r/4 ( fl + fr + rl + rr)
///     front_right = (x + y + k w) / r        y = r/4 (-fl + fr + rl - rr)
///     rear_left   = (x + y - k w) / r        w = r/(4 k) (-fl + fr - rl + rr)
///     rear_right  = (x - y + k w) / r
///
/// The right-hand side is the least-squares inverse of the left: four wheels, three degrees of
/// freedom. Taheri, Qiao, Ghaeminezhad 2015, "Kinematic Model of a Four Mecanum Wheeled Mobile
/// Robot", Eq. 20 and 21.
class MecanumKinematics {
 public:
  /// @throws std::invalid_argument unless all lengths are finite and > 0
  explicit MecanumKinematics(const MecanumGeometry& geometry);

  /// Inverse kinematics: what the wheels have to do.
  WheelSpeeds toWheels(const Twist2d& twist_robot) const;

  /// Forward kinematics: how the base moves.
  Twist2d toTwist(const WheelSpeeds& wheels) const;

  /// Slows a motion down, keeping its direction and its ratio of turning to driving, until no wheel
  /// is faster than `limit_radps`.
  /// @throws std::invalid_argument unless limit_radps > 0
  Twist2d limitWheels(const Twist2d& twist_robot, double limit_radps) const;

 private:
  double radius_m_;
  double lever_m_;  // half_wheelbase + half_track
};

}  // namespace sylph
