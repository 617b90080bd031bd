#pragma once

#include <cstdint>
#include <string>

namespace sylph {

/// How far the central node is with a plan, see AdgState.msg.
enum class ExecutionPhase : std::uint8_t {
  Idle = 0,     ///< no plan
  Pending = 1,  ///< a plan has come and waits until it may start
  Executing = 2,
  Cutting = 3,   ///< robots run to the commit cut, for a new plan from there
  AtCut = 4,     ///< all at the cut: waiting for the plan that replaces this one
  Finished = 5,  ///< every robot that is not lost has done all its tasks
  Refused = 6,   ///< the plan cannot be executed
};

/// What robots may do, by the operator's or the separation monitor's word.
enum class ExecutionMode : std::uint8_t {
  Run = 0,
  Pause = 1,  ///< no new task is released, robots finish those that they have
  Stop = 2,   ///< robots ramp to zero at once
};

/// What the central node's watchdogs think of a robot.
enum class RobotCondition : std::uint8_t {
  Ok = 0,
  Silent = 1,  ///< no report for longer than the limit
  Stuck = 2,   ///< no progress for longer than the limit
  Blind = 3,   ///< reports that it has no good pose
  Lost = 4,    ///< out of the mission; its cells stay held
};

/// What a robot does.
enum class RobotState : std::uint8_t {
  Idle = 0,     ///< no task left, holds its position
  Moving = 1,   ///< carries out a task
  Holding = 2,  ///< has a task but does not move: paused, stopped, or the central node is silent
  Blind = 3,    ///< its pose is not to be trusted: ramps to zero and waits for good poses
};

std::string toString(ExecutionPhase phase);
std::string toString(ExecutionMode mode);
std::string toString(RobotCondition condition);

}  // namespace sylph
