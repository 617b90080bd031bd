#pragma once

#include <array>
#include <deque>

#include "sylph_core/control/mecanum.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_sim/bounds.hpp"

namespace sylph_sim {

/// What a simulated base is like. Noise is drawn anew for each robot from its seed.
struct BaseOptions {
  sylph::MecanumGeometry geometry;
  double wheel_speed_limit_radps = 15.0;
  double wheel_acceleration_limit_radps2 = 40.0;
  double wheel_lag_s = 0.08;          ///< time constant of the wheel speed controllers
  double command_latency_s = 0.02;    ///< from a command's arrival to its effect
  double command_timeout_s = 0.1;     ///< the base latches a command for this long
  double command_resolution = 0.001;  ///< step of a command [m/s, rad/s], 0 for none
  double wheel_scale_error = 0.01;    ///< standard deviation of a wheel's constant gain
  double speed_noise = 0.02;          ///< standard deviation relative to the speed
  double slip = 0.02;                 ///< mean share of a wheel's turn that is lost
  double slip_noise = 0.02;           ///< standard deviation of that share
  double lateral_slip = 0.04;         ///< share of a sideways motion that is lost
  double noise_correlation_s = 0.2;   ///< time over which speed and slip noise persist
};

/// Shows each number with its bounds and meaning.
void visitNumbers(BaseOptions& options, const NumberVisitor& visit);

/// @throws std::invalid_argument naming the member, its value and its bound
void requireValid(const BaseOptions& options);

/// What is wrong with a base at one moment.
struct BaseFault {
  double speed_factor = 1.0;  ///< of all wheels; 0: stuck
  bool is_dead = false;       ///< no power: the wheels run down whatever the command
  double drift_mps = 0.0;     ///< pushed to its left
};

/// The pose after moving with a constant velocity for `duration_s`, exactly: an arc or a line.
sylph::Pose2d integrate(const sylph::Pose2d& pose, const sylph::Twist2d& twist_robot,
                        double duration_s);

/// One mecanum robot: command -> delay -> wheel speeds -> lag, limits, noise, slip -> motion.
class MecanumBase {
 public:
  /// @throws std::invalid_argument as requireValid()
  MecanumBase(const BaseOptions& options, const sylph::Pose2d& pose, sylph::Rng rng);

  /// A velocity command in the robot's frame that arrives at `time_s`. One that is not finite is
  /// ignored.
  void command(const sylph::Twist2d& twist_robot, double time_s);

  /// Moves on from `time_s` by `duration_s` > 0.
  void step(double time_s, double duration_s, const BaseFault& fault = {});

  /// True pose in `map`.
  const sylph::Pose2d& pose() const { return pose_; }
  /// True velocity in the robot's frame during the last step.
  const sylph::Twist2d& twist() const { return twist_robot_; }

 private:
  using Wheels = std::array<double, 4>;

  struct Command {
    double effective_s;  // when it reaches the wheels
    sylph::Twist2d twist_robot;
  };

  sylph::Twist2d commandAt(double time_s);
  void turnWheels(const Wheels& targets, double duration_s);
  Wheels rollingSpeeds(double duration_s);

  BaseOptions options_;
  sylph::MecanumKinematics kinematics_;
  sylph::Rng rng_;
  std::deque<Command> commands_;  // the one in effect first, then those on their way
  sylph::Pose2d pose_;
  sylph::Twist2d twist_robot_;
  Wheels wheels_radps_{};
  Wheels gains_{};
  Wheels speed_noise_{};  // relative
  Wheels slip_noise_{};
};

}  // namespace sylph_sim
