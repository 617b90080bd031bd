#include "sylph_mocap_bridge/body_tracker.hpp"

#include <cmath>

namespace sylph_mocap_bridge {
namespace {

/// Before its first rate a filter takes any as likely as not [units/s, squared].
constexpr double kUnknownRateVariance = 100.0;
/// Two samples give a first rate; some more make it one to rely on.
constexpr int kLeastSamples = 5;
/// A jump smaller than this is noise, whatever the speed that it implies.
constexpr double kJumpMarginM = 0.02;

double square(double x) {
  return x * x;
}

/// `angle_rad` plus the whole turns that bring it closest to `reference_rad`.
double unwrapped(double angle_rad, double reference_rad) {
  return reference_rad + std::remainder(angle_rad - reference_rad, 2.0 * M_PI);
}

}  // namespace

void RateFilter::start(double value, double measurement_variance) {
  value_ = value;
  rate_ = 0.0;
  value_variance_ = measurement_variance;
  covariance_ = 0.0;
  rate_variance_ = kUnknownRateVariance;
}

void RateFilter::update(double value, double dt_s, double measurement_variance,
                        double acceleration_variance) {
  // Predict.
  value_ += rate_ * dt_s;
  value_variance_ += dt_s * (2.0 * covariance_ + dt_s * rate_variance_) +
                     acceleration_variance * square(square(dt_s)) / 4.0;
  covariance_ += dt_s * rate_variance_ + acceleration_variance * dt_s * square(dt_s) / 2.0;
  rate_variance_ += acceleration_variance * square(dt_s);
  // Correct.
  const double innovation_variance = value_variance_ + measurement_variance;
  const double value_gain = value_variance_ / innovation_variance;
  const double rate_gain = covariance_ / innovation_variance;
  const double innovation = value - value_;
  value_ += value_gain * innovation;
  rate_ += rate_gain * innovation;
  rate_variance_ -= rate_gain * covariance_;
  covariance_ *= 1.0 - value_gain;
  value_variance_ *= 1.0 - value_gain;
}

bool BodyTracker::continues(const Pose& pose, double dt_s) const {
  const double jump_m = std::hypot(pose.position_m.x() - x_.value() - x_.rate() * dt_s,
                                   pose.position_m.y() - y_.value() - y_.rate() * dt_s);
  return samples_ > 0 && dt_s > 0.0 && dt_s <= options_.largest_gap_s &&
         jump_m <= options_.largest_speed_mps * dt_s + kJumpMarginM;
}

std::optional<Velocity> BodyTracker::update(const Pose& map_from_robot, double time_s) {
  const double position_variance = square(options_.position_sigma_m);
  const double heading_variance = square(options_.heading_sigma_rad);
  const double dt_s = time_s - time_s_;
  const double yaw_rad = yawOf(map_from_robot);
  time_s_ = time_s;
  if (!continues(map_from_robot, dt_s)) {
    x_.start(map_from_robot.position_m.x(), position_variance);
    y_.start(map_from_robot.position_m.y(), position_variance);
    yaw_.start(yaw_rad, heading_variance);
    samples_ = 1;
    return std::nullopt;
  }
  const double linear = square(options_.acceleration_sigma_mps2);
  const double angular = square(options_.acceleration_sigma_radps2);
  x_.update(map_from_robot.position_m.x(), dt_s, position_variance, linear);
  y_.update(map_from_robot.position_m.y(), dt_s, position_variance, linear);
  yaw_.update(unwrapped(yaw_rad, yaw_.value()), dt_s, heading_variance, angular);
  if (++samples_ < kLeastSamples) {
    return std::nullopt;
  }
  samples_ = kLeastSamples;
  return Velocity{x_.rate(), y_.rate(), yaw_.rate(), x_.rateVariance(), yaw_.rateVariance()};
}

}  // namespace sylph_mocap_bridge
