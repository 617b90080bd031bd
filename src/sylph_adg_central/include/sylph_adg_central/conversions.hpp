#pragma once

#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/RobotExecution.h>

#include <string>

#include "sylph_core/adg/execution.hpp"
#include "sylph_core/execution/robot_view.hpp"

namespace sylph_adg_central {

sylph_msgs::RobotExecution toMessage(const sylph::RobotView& view, const std::string& robot);

/// Stamp, steps and elapsed time are left to the caller.
/// @param now_s  steady time [s]
sylph_msgs::AdgState toMessage(const sylph::Execution& execution, double now_s);

}  // namespace sylph_adg_central
