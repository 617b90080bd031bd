#pragma once

#include <optional>

#include "sylph_mocap_bridge/pose.hpp"

namespace sylph_mocap_bridge {

/// How a robot moves in the plane of the map.
struct Velocity {
  double x_mps = 0.0;             ///< along the map's x axis
  double y_mps = 0.0;             ///< along the map's y axis
  double yaw_radps = 0.0;         ///< counter-clockwise
  double linear_variance = 0.0;   ///< of x_mps and of y_mps [(m/s)^2]
  double angular_variance = 0.0;  ///< [(rad/s)^2]
};

/// How noisy poses are and how robots move.
struct TrackerOptions {
  double position_sigma_m = 0.0003;        ///< noise of a measured position, > 0
  double heading_sigma_rad = 0.003;        ///< noise of a measured heading, > 0
  double acceleration_sigma_mps2 = 1.0;    ///< how wildly a robot accelerates, > 0
  double acceleration_sigma_radps2 = 3.0;  ///< how wildly it starts to turn, > 0
  double largest_gap_s = 0.25;             ///< a longer gap begins anew, > 0
  double largest_speed_mps = 2.0;          ///< a faster jump begins anew, > 0
};

/// One coordinate that moves with a nearly constant rate: a Kalman filter of value and rate, whose
/// steady state is the alpha-beta filter. Process noise is a piecewise constant acceleration
/// (Bar-Shalom, Li, Kirubarajan 2001, section 6.3.2).
class RateFilter {
 public:
  /// Begins anew at a value whose rate is not known.
  void start(double value, double measurement_variance);
  /// @param dt_s  since the last value, > 0
  void update(double value, double dt_s, double measurement_variance, double acceleration_variance);

  double value() const { return value_; }
  double rate() const { return rate_; }
  /// Of rate(), by the filter.
  double rateVariance() const { return rate_variance_; }

 private:
  double value_ = 0.0;
  double rate_ = 0.0;
  double value_variance_ = 0.0;
  double covariance_ = 0.0;
  double rate_variance_ = 0.0;
};

/// Velocity of one robot from its valid poses. Times are the camera system's own, so that neither
/// the network's jitter nor a coarse clock gets into the velocity.
class BodyTracker {
 public:
  explicit BodyTracker(const TrackerOptions& options) : options_(options) {}

  /// @param time_s  of the exposure; one that is not later than the last begins anew
  /// @return nothing until it has seen enough after a start, a gap or a jump
  std::optional<Velocity> update(const Pose& map_from_robot, double time_s);
  /// Begins anew with the next pose.
  void reset() { samples_ = 0; }

 private:
  bool continues(const Pose& pose, double dt_s) const;

  TrackerOptions options_;
  RateFilter x_;
  RateFilter y_;
  RateFilter yaw_;
  double time_s_ = 0.0;
  int samples_ = 0;
};

}  // namespace sylph_mocap_bridge
