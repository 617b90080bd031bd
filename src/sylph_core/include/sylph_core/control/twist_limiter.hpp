#pragma once

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

/// What a base may be told.
struct TwistLimits {
  double speed_mps = 0.25;                ///< of the velocity vector, > 0
  double acceleration_mps2 = 2.0;         ///< of the velocity vector, > 0
  double turn_rate_radps = 0.5;           ///< > 0
  double turn_acceleration_radps2 = 4.0;  ///< > 0
};

/// Keeps a stream of commands within limits. The velocity is limited as a vector, so that its
/// direction stays; its change per time is limited as a vector as well.
class TwistLimiter {
 public:
  /// @throws std::invalid_argument unless all limits are > 0
  explicit TwistLimiter(const TwistLimits& limits);

  /// The closest command to `wanted` that the limits allow `dt_s` after the last one.
  const Twist2d& limit(const Twist2d& wanted, double dt_s);

  /// The same towards standstill, with an acceleration of its own [m/s^2].
  const Twist2d& ramp(double deceleration_mps2, double dt_s);

  const Twist2d& last() const { return last_; }

 private:
  const Twist2d& approach(const Twist2d& wanted, double acceleration_mps2, double dt_s);

  TwistLimits limits_;
  Twist2d last_;
};

}  // namespace sylph
