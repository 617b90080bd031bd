#pragma once

#include "sylph_core/adg/execution.hpp"
#include "sylph_core/execution/adg_state.hpp"

/// What is known of an execution, for operator and messages.
namespace sylph {

/// Where a robot is, what it does, whom it waits for and who holds it up.
/// @param now_s  steady time [s]
/// @throws std::out_of_range if there is no such robot
RobotExecution explain(const Execution& execution, int robot, double now_s);

/// All of it; the elapsed time is left to the caller.
AdgState explain(const Execution& execution, double now_s);

/// Robots of the mission that are where it sends them.
int arrivedRobots(const Execution& execution);

}  // namespace sylph
