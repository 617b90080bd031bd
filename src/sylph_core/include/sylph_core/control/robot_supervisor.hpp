#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sylph_core/execution/states.hpp"

namespace sylph {

/// How far a robot may move now.
enum class Permission {
  Drive,       ///< through all accepted tasks; without one, keep the place
  FinishTask,  ///< to the end of the current task and no further
  Stop,        ///< ramp to zero at once
};

/// Everything that decides whether a robot may move.
struct RobotSituation {
  std::optional<std::string> pose_problem;    ///< why the pose is not trusted
  std::optional<std::string> motion_problem;  ///< why it is not believed to be this robot's
  bool has_task = false;
  bool has_finished_last_task = false;      ///< since the central node fell silent
  bool is_aligning = false;                 ///< turns and drives to the middle of its cell
  bool has_aligned = false;                 ///< is there
  std::optional<double> central_silence_s;  ///< since the last AdgState; nothing before the first
  ExecutionMode mode = ExecutionMode::Run;
  bool is_emergency = false;
  std::optional<std::uint32_t> other_plan_id;  ///< of its tasks, if nobody carries that plan out
  bool is_displaced = false;                   ///< outside the cells that its tasks hold
  double heading_error_rad = 0.0;
};

/// When a robot holds although its pose is good.
struct SupervisorLimits {
  double central_timeout_s = 0.5;  ///< > 0
  /// Larger heading errors are for an operator to correct (20 deg), > 0.
  double heading_correction_rad = 0.349065850398866;
};

/// What decide() has come to.
struct RobotDecision {
  RobotState state = RobotState::Holding;
  Permission permission = Permission::Stop;
  std::string detail;  ///< why it does not move, for the operator
};

/// The one place where it is decided whether a robot moves, in order of urgency: pose, emergency
/// stop, central node, place, heading.
RobotDecision decide(const RobotSituation& situation, const SupervisorLimits& limits);

/// Remembers an emergency stop until the operator has let go of it twice: the stop itself is over,
/// and the central node was stopped and told to go on. So its end alone never moves a robot.
class EmergencyLatch {
 public:
  /// The state of the button, as it is repeated.
  void onEmergencyStop(bool is_pressed);
  /// The mode of the last AdgState.
  void onCentralMode(ExecutionMode mode);
  bool isActive() const { return is_pressed_ || is_waiting_for_resume_; }

 private:
  bool is_pressed_ = false;
  bool is_waiting_for_resume_ = false;
  bool was_stopped_ = false;
};

}  // namespace sylph
