#include "sylph_core/control/robot_supervisor.hpp"

#include <cmath>

#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

bool hasToMove(const RobotSituation& situation) {
  return situation.has_task || (situation.is_aligning && !situation.has_aligned);
}

RobotDecision stop(const RobotSituation& situation, const std::string& detail) {
  return {hasToMove(situation) ? RobotState::Holding : RobotState::Idle, Permission::Stop, detail};
}

}  // namespace

RobotDecision decide(const RobotSituation& situation, const SupervisorLimits& limits) {
  // In the order in which an operator has to mend them: without a pose nothing else can be judged.
  if (situation.pose_problem) {
    return {RobotState::Blind, Permission::Stop, *situation.pose_problem};
  }
  if (situation.is_emergency) {
    return stop(situation, "emergency stop");
  }
  if (!situation.central_silence_s) {
    return stop(situation, "central node not heard yet");
  }
  if (situation.mode == ExecutionMode::Stop) {
    return stop(situation, "stopped by the central node");
  }
  if (situation.other_plan_id) {
    return stop(situation, "its tasks are of plan " + std::to_string(*situation.other_plan_id) +
                               ", which the central node does not carry out");
  }
  if (situation.motion_problem) {
    return stop(situation, *situation.motion_problem);
  }
  // Whether a robot may be aligned from where it stands is for the central node to judge.
  if (situation.is_displaced && !situation.is_aligning) {
    return stop(situation, "outside the cells of its task: put it back");
  }
  if (std::abs(situation.heading_error_rad) > limits.heading_correction_rad &&
      !situation.is_aligning) {
    return stop(situation, format("heading is %.0f deg off: turn it by hand",
                                  std::abs(situation.heading_error_rad) * 180.0 / M_PI));
  }
  if (*situation.central_silence_s > limits.central_timeout_s) {
    const std::string detail =
        format("central node silent for %.1f s", *situation.central_silence_s);
    // Its cells are its own until it says that it has left them: to finish the task is safe without
    // the central node, to begin another or to be aligned is not.
    if (!situation.has_task || situation.has_finished_last_task) {
      return stop(situation, detail);
    }
    return {RobotState::Moving, Permission::FinishTask, detail};
  }
  return {hasToMove(situation) ? RobotState::Moving : RobotState::Idle, Permission::Drive, ""};
}

void EmergencyLatch::onEmergencyStop(bool is_pressed) {
  // A resume from before the press must not release it: only one that follows a Stop of the central
  // node, by the operator.
  if (is_pressed && !is_pressed_) {
    is_waiting_for_resume_ = true;
    was_stopped_ = false;
  }
  is_pressed_ = is_pressed;
}

void EmergencyLatch::onCentralMode(ExecutionMode mode) {
  if (mode == ExecutionMode::Stop) {
    was_stopped_ = true;
  } else if (mode == ExecutionMode::Run && was_stopped_ && !is_pressed_) {
    is_waiting_for_resume_ = false;
  }
}

}  // namespace sylph
