#pragma once

#include <cstdint>
#include <optional>

namespace sylph_sim {

/// Tells how many simulation steps are due, from a steady wall clock that it is given.
///
/// When the machine is too slow the steps that are overdue are put off, never skipped: simulated
/// time runs slower than asked for, and speed() says by how much. Steps that are caught up on in
/// one go pass while no controller can answer, so they may be few.
class StepPacer {
 public:
  /// @param step_s         simulated seconds a step, > 0
  /// @param target_speed   simulated seconds a wall second, > 0
  /// @param max_backlog_s  simulated time that is caught up on in one go after a hitch, > 0
  /// @throws std::invalid_argument if one is not
  StepPacer(double step_s, double target_speed, double max_backlog_s);

  /// Steps that are due at `wall_s`, which never runs backwards; the caller carries out them all.
  /// The first call starts the clock.
  int stepsDue(double wall_s);

  /// Simulated seconds a wall second, over the last full second of the wall; the target at first.
  double speed() const { return speed_; }
  /// Simulated seconds per second that it aims at.
  double targetSpeed() const { return target_speed_; }

 private:
  void measure(double wall_s, int due);

  double step_s_;
  double target_speed_;
  double max_backlog_s_;
  std::optional<double> origin_wall_s_;  // steps_ counts from here
  std::int64_t steps_ = 0;
  double window_wall_s_ = 0.0;
  std::int64_t window_steps_ = 0;
  double speed_;
};

}  // namespace sylph_sim
