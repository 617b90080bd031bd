#pragma once

#include <deque>
#include <limits>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

/// Pose and velocity at one moment.
struct MotionState {
  Pose2d pose;
  Twist2d twist_map;  ///< velocity along the axes of the map
};

/// How a base answers to commands.
struct BaseModel {
  double latency_s = 0.025;  ///< from sending a command until the wheels begin to follow it, >= 0
  double lag_s = 0.08;       ///< time constant with which the speed then follows, >= 0
  double timeout_s = std::numeric_limits<double>::infinity();  ///< it stops so long after the last
                                                               ///< command by itself, > 0
};

/// Where a robot is now, from where it was when the cameras saw it and from what it was told since.
///
/// Model of the base, with u the commands in the map frame and v its velocity:
///
///     lag dv/dt = u(t - latency) - v
///
/// solved exactly between commands; u is zero from `timeout_s` after the last command on. So a
/// delay costs no phase in the control loop as far as the model holds (Smith 1957, "Closer control
/// of loops with dead time").
class PosePredictor {
 public:
  /// @throws std::invalid_argument if latency or lag is negative or not finite, or the timeout not
  /// positive
  explicit PosePredictor(const BaseModel& model);

  /// Tells of a command sent at `time_s`; times must not decrease.
  void command(double time_s, const Twist2d& twist_map);
  /// From now on nobody asks for poses captured before `time_s`.
  void forgetBefore(double time_s);

  /// The state at `time_s`, from a pose captured at `captured_s`. What is forgotten counts as
  /// motion that is over; so do all commands but the last 500.
  MotionState predict(const Pose2d& captured, double captured_s, double time_s) const;

 private:
  struct Command {
    double effective_s;
    Twist2d twist_map;
    Twist2d before_map;  // of the base when the command takes effect
  };

  /// When the base stops by itself unless another command comes.
  double timedOut() const { return sent_s_ + model_.timeout_s + model_.latency_s; }
  void append(double effective_s, const Twist2d& twist_map);

  BaseModel model_;
  std::deque<Command> commands_;  // oldest first
  double sent_s_ = 0.0;           // the last command, if there is one
};

}  // namespace sylph
