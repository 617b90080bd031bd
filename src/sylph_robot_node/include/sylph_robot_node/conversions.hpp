#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <optional>
#include <string>

#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph_robot_node {

/// A task as the core knows it.
/// @param reason  set if there is nothing to return: status or action out of range, the cells
///                contradict the action, or the positions are not the cells' centres
std::optional<sylph::AssignedTask> fromMessage(const sylph_msgs::Task& message,
                                               const sylph::CellFrame& frame, std::string& reason);

/// Position and yaw; the yaw is not a number unless the quaternion is of unit length (0.9 ... 1.1).
sylph::Pose2d fromMessage(const geometry_msgs::Pose& message);

/// Nothing if the number is no mode.
std::optional<sylph::CentralMode> modeFromMessage(const sylph_msgs::AdgState& message);

geometry_msgs::Twist toMessage(const sylph::Twist2d& twist_robot);

/// All but header, robot_id and report_id.
sylph_msgs::TaskReport toMessage(const sylph::RobotStatus& status);

}  // namespace sylph_robot_node
