#include "sylph_robot_node/conversions.hpp"

#include <cmath>
#include <limits>

#include "sylph_ros/conversions.hpp"

namespace sylph_robot_node {
sylph::Pose2d fromMessage(const geometry_msgs::Pose& message) {
  const geometry_msgs::Quaternion& q = message.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const bool is_rotation = norm > 0.9 && norm < 1.1;
  return {message.position.x, message.position.y,
          is_rotation ? sylph_ros::yawOf(q) : std::numeric_limits<double>::quiet_NaN()};
}

geometry_msgs::Twist toMessage(const sylph::Twist2d& twist_robot) {
  geometry_msgs::Twist message;
  message.linear.x = twist_robot.x_mps;
  message.linear.y = twist_robot.y_mps;
  message.angular.z = twist_robot.turn_radps;
  return message;
}

}  // namespace sylph_robot_node
