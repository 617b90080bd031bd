#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph_robot_node {

/// Position and yaw; the yaw is not a number unless the quaternion is of unit length (0.9 ... 1.1).
sylph::Pose2d fromMessage(const geometry_msgs::Pose& message);

geometry_msgs::Twist toMessage(const sylph::Twist2d& twist_robot);

}  // namespace sylph_robot_node
