#pragma once

#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/experiment/experiment.hpp"

namespace sylph {

/// Gives a controller what all nodes share: limits, tolerances, time-outs of the experiment.
void applyExecution(const ExecutionSpec& execution, RobotControllerOptions& controller);

/// A controller with what all nodes share; the rest keeps its defaults.
RobotControllerOptions controllerOptionsFor(const ExecutionSpec& execution);

}  // namespace sylph
