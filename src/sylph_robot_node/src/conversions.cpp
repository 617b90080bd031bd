#include "sylph_robot_node/conversions.hpp"

namespace sylph_robot_node {

geometry_msgs::Twist toMessage(const sylph::Twist2d& twist_robot) {
  geometry_msgs::Twist message;
  message.linear.x = twist_robot.x_mps;
  message.linear.y = twist_robot.y_mps;
  message.angular.z = twist_robot.turn_radps;
  return message;
}

}  // namespace sylph_robot_node
