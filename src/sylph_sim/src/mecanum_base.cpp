#include "sylph_sim/mecanum_base.hpp"

#include <algorithm>
#include <cmath>

#include "sylph_sim/bounds.hpp"

namespace sylph_sim {
namespace {

double rounded(double value, double resolution) {
  return resolution > 0.0 ? std::round(value / resolution) * resolution : value;
}

/// One step of a random process with mean 0 and a memory of `correlation_s` (Ornstein-Uhlenbeck,
/// exact discretisation).
class NoiseStep {
 public:
  NoiseStep(double duration_s, double correlation_s)
      : memory_(std::exp(-duration_s / correlation_s)),
        share_(std::sqrt(1.0 - memory_ * memory_)) {}

  /// The value after `value`, of a process with standard deviation `deviation`.
  double next(double value, double deviation, double unit_normal) const {
    return value * memory_ + deviation * share_ * unit_normal;
  }

 private:
  double memory_;
  double share_;  // of the deviation that is drawn anew
};

}  // namespace

void visitNumbers(BaseOptions& options, const NumberVisitor& visit) {
  const sylph::Range positive = sylph::Range::positive();
  const sylph::Range not_negative = sylph::Range::atLeast(0.0);
  const sylph::Range up_to_half{0.0, 0.5};
  visit("wheel_radius_m", options.geometry.wheel_radius_m, positive, "of each wheel");
  visit("half_wheelbase_m", options.geometry.half_wheelbase_m, positive,
        "centre to wheel axes, forward");
  visit("half_track_m", options.geometry.half_track_m, positive,
        "centre to wheel contacts, sideways");
  visit("wheel_speed_limit_radps", options.wheel_speed_limit_radps, positive, "of each wheel");
  visit("wheel_acceleration_limit_radps2", options.wheel_acceleration_limit_radps2, positive,
        "of each wheel");
  visit("wheel_lag_s", options.wheel_lag_s, not_negative,
        "time constant of the wheel speed controllers");
  visit("command_latency_s", options.command_latency_s, not_negative,
        "from a command's arrival to its effect");
  visit("command_timeout_s", options.command_timeout_s, positive,
        "the base latches a command for this long: `base_timeout_s` of the experiment");
  visit("command_resolution", options.command_resolution, not_negative,
        "step of a command [m/s, rad/s]; 0: none");
  visit("wheel_scale_error", options.wheel_scale_error, {0.0, 0.2},
        "standard deviation of each wheel's constant gain");
  visit("speed_noise", options.speed_noise, up_to_half,
        "standard deviation of wheel speed, relative");
  visit("slip", options.slip, up_to_half, "mean share of a wheel's turn that is lost");
  visit("slip_noise", options.slip_noise, up_to_half, "standard deviation of that share");
  visit("lateral_slip", options.lateral_slip, up_to_half, "share of sideways motion that is lost");
  visit("noise_correlation_s", options.noise_correlation_s, positive,
        "time over which speed and slip noise persist");
}

void requireValid(const BaseOptions& options) {
  requireNumbersWithin(options);
}

sylph::Pose2d integrate(const sylph::Pose2d& pose, const sylph::Twist2d& twist_robot,
                        double duration_s) {
  const double turn_rad = twist_robot.turn_radps * duration_s;
  // sin(a)/a and (1 - cos(a))/a, by their series where the quotient would lose digits.
  const bool is_small = std::abs(turn_rad) < 1e-6;
  const double along = is_small ? 1.0 : std::sin(turn_rad) / turn_rad;
  const double across = is_small ? turn_rad / 2.0 : (1.0 - std::cos(turn_rad)) / turn_rad;
  const sylph::Pose2d before_from_after{
      (twist_robot.x_mps * along - twist_robot.y_mps * across) * duration_s,
      (twist_robot.x_mps * across + twist_robot.y_mps * along) * duration_s, turn_rad};
  return compose(pose, before_from_after);
}

MecanumBase::MecanumBase(const BaseOptions& options, const sylph::Pose2d& pose, sylph::Rng rng)
    : options_(options), kinematics_(options.geometry), rng_(rng), pose_(pose) {
  requireValid(options);
  for (double& gain : gains_) {
    // Clipped, so that no draw makes a wheel that hardly turns.
    gain = 1.0 + options_.wheel_scale_error * std::clamp(sylph::drawNormal(rng_), -2.5, 2.5);
  }
}

void MecanumBase::command(const sylph::Twist2d& twist_robot, double time_s) {
  // As a base does that refuses what it cannot read.
  if (!std::isfinite(twist_robot.x_mps) || !std::isfinite(twist_robot.y_mps) ||
      !std::isfinite(twist_robot.turn_radps)) {
    return;
  }
  const double resolution = options_.command_resolution;
  commands_.push_back(
      {time_s + options_.command_latency_s,
       {rounded(twist_robot.x_mps, resolution), rounded(twist_robot.y_mps, resolution),
        rounded(twist_robot.turn_radps, resolution)}});
}

void MecanumBase::step(double time_s, double duration_s, const BaseFault& fault) {
  const sylph::Twist2d command = commandAt(time_s);
  const sylph::WheelSpeeds targets =
      kinematics_.toWheels(fault.is_dead ? sylph::Twist2d{} : command);
  turnWheels({targets.front_left_radps, targets.front_right_radps, targets.rear_left_radps,
              targets.rear_right_radps},
             duration_s);
  const Wheels rolling = rollingSpeeds(duration_s);
  twist_robot_ = kinematics_.toTwist({rolling[0], rolling[1], rolling[2], rolling[3]});
  twist_robot_.x_mps *= fault.speed_factor;
  twist_robot_.y_mps *= fault.speed_factor * (1.0 - options_.lateral_slip);
  twist_robot_.turn_radps *= fault.speed_factor;
  twist_robot_.y_mps += fault.drift_mps;
  pose_ = integrate(pose_, twist_robot_, duration_s);
}

sylph::Twist2d MecanumBase::commandAt(double time_s) {
  while (commands_.size() > 1 && commands_[1].effective_s <= time_s) {
    commands_.pop_front();
  }
  if (commands_.empty() || commands_.front().effective_s > time_s ||
      time_s - commands_.front().effective_s > options_.command_timeout_s) {
    return {};
  }
  return commands_.front().twist_robot;
}

void MecanumBase::turnWheels(const Wheels& targets, double duration_s) {
  const double approach =
      options_.wheel_lag_s > 0.0 ? 1.0 - std::exp(-duration_s / options_.wheel_lag_s) : 1.0;
  const double limit = options_.wheel_speed_limit_radps;
  const double change_limit = options_.wheel_acceleration_limit_radps2 * duration_s;
  for (std::size_t wheel = 0; wheel < wheels_radps_.size(); ++wheel) {
    const double target = std::clamp(targets[wheel], -limit, limit);
    const double change = (target - wheels_radps_[wheel]) * approach;
    wheels_radps_[wheel] += std::clamp(change, -change_limit, change_limit);
  }
}

MecanumBase::Wheels MecanumBase::rollingSpeeds(double duration_s) {
  const NoiseStep noise(duration_s, options_.noise_correlation_s);
  Wheels rolling{};
  for (std::size_t wheel = 0; wheel < rolling.size(); ++wheel) {
    speed_noise_[wheel] =
        noise.next(speed_noise_[wheel], options_.speed_noise, sylph::drawNormal(rng_));
    slip_noise_[wheel] =
        noise.next(slip_noise_[wheel], options_.slip_noise, sylph::drawNormal(rng_));
    const double slip = std::clamp(options_.slip + slip_noise_[wheel], 0.0, 1.0);
    rolling[wheel] =
        wheels_radps_[wheel] * gains_[wheel] * (1.0 + speed_noise_[wheel]) * (1.0 - slip);
  }
  return rolling;
}

}  // namespace sylph_sim
