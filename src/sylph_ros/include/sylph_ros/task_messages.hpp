#pragma once

#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <optional>
#include <string>

#include "sylph_core/execution/robot_report.hpp"
#include "sylph_core/execution/task_order.hpp"
#include "sylph_core/grid/cell_frame.hpp"

/// Orders and reports on the wire between central node and robots.
namespace sylph_ros {

/// Stamp left to the caller.
sylph_msgs::Task toMessage(const sylph::TaskOrder& order, const std::string& robot,
                           const sylph::CellFrame& frame);

/// The order; the robot's index is left out.
/// @param reason  set if there is nothing to return: status, action or a number out of range, the
/// cells contradict the action, or the positions are not the cells' centres
std::optional<sylph::TaskOrder> fromMessage(const sylph_msgs::Task& message,
                                            const sylph::CellFrame& frame, std::string& reason);

/// Header and robot_id left to the caller. Without a pose its numbers are NaN.
sylph_msgs::TaskReport toMessage(const sylph::RobotReport& report);

/// @return nothing if the state is none or a number is out of range; a pose that is not finite is
/// left out
std::optional<sylph::RobotReport> fromMessage(const sylph_msgs::TaskReport& message);

}  // namespace sylph_ros
