#pragma once

#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/RobotExecution.h>
#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <optional>
#include <string>

#include "sylph_core/adg/execution.hpp"
#include "sylph_core/execution/robot_report.hpp"
#include "sylph_core/execution/robot_view.hpp"
#include "sylph_core/execution/task_order.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph_adg_central {

/// Stamp left to the caller.
sylph_msgs::Task toMessage(const sylph::TaskOrder& order, const std::string& robot,
                           const sylph::CellFrame& frame);

/// @return nothing if the state is none or a number is out of range; a position that is not a
/// number is left out
std::optional<sylph::RobotReport> fromMessage(const sylph_msgs::TaskReport& message);

sylph_msgs::RobotExecution toMessage(const sylph::RobotView& view, const std::string& robot);

/// Stamp, counts of received steps and elapsed time are left to the caller.
/// @param now_s  steady time [s]
sylph_msgs::AdgState toMessage(const sylph::Execution& execution, double now_s);

}  // namespace sylph_adg_central
