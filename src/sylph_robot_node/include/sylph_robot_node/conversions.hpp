#pragma once

#include <geometry_msgs/Twist.h>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph_robot_node {

geometry_msgs::Twist toMessage(const sylph::Twist2d& twist_robot);

}  // namespace sylph_robot_node
