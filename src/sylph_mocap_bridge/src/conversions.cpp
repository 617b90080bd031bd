#include "sylph_mocap_bridge/conversions.hpp"

#include <cassert>

#include "sylph_ros/topics.hpp"

namespace sylph_mocap_bridge {
namespace {

/// Of what is not measured.
constexpr double kUnknownVariance = 1e6;

std_msgs::Header headerOf(const ReliablePose& pose) {
  std_msgs::Header header;
  header.frame_id = sylph_ros::kMapFrame;
  header.stamp = ros::Time(pose.stamp_s);
  return header;
}

geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& orientation) {
  geometry_msgs::Quaternion message;
  message.x = orientation.x();
  message.y = orientation.y();
  message.z = orientation.z();
  message.w = orientation.w();
  return message;
}

/// Index of a variance in a row-major 6 x 6 covariance.
constexpr std::size_t diagonal(std::size_t i) {
  return i * 7;
}

}  // namespace

geometry_msgs::Pose toMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.position_m.x();
  message.position.y = pose.position_m.y();
  message.position.z = pose.position_m.z();
  message.orientation = toMessage(pose.orientation);
  return message;
}

geometry_msgs::PoseStamped toPoseStamped(const ReliablePose& pose) {
  geometry_msgs::PoseStamped message;
  message.header = headerOf(pose);
  message.pose = toMessage(pose.map_from_robot);
  return message;
}

geometry_msgs::TransformStamped toTransform(const ReliablePose& pose, const std::string& robot) {
  geometry_msgs::TransformStamped message;
  message.header = headerOf(pose);
  message.child_frame_id = robot;
  message.transform.translation.x = pose.map_from_robot.position_m.x();
  message.transform.translation.y = pose.map_from_robot.position_m.y();
  message.transform.translation.z = pose.map_from_robot.position_m.z();
  message.transform.rotation = toMessage(pose.map_from_robot.orientation);
  return message;
}

nav_msgs::Odometry toOdometry(const ReliablePose& pose, const std::string& robot,
                              const TrackerOptions& noise) {
  assert(pose.velocity);
  nav_msgs::Odometry message;
  message.header = headerOf(pose);
  message.child_frame_id = robot;
  message.pose.pose = toMessage(pose.map_from_robot);
  for (std::size_t i = 0; i < 3; ++i) {
    message.pose.covariance[diagonal(i)] = noise.position_sigma_m * noise.position_sigma_m;
    message.pose.covariance[diagonal(i + 3)] = noise.heading_sigma_rad * noise.heading_sigma_rad;
    message.twist.covariance[diagonal(i)] = kUnknownVariance;
    message.twist.covariance[diagonal(i + 3)] = kUnknownVariance;
  }
  const Velocity& velocity = *pose.velocity;
  const sylph::Twist2d twist_robot = sylph::robotFromMap(
      {velocity.x_mps, velocity.y_mps, velocity.yaw_radps}, yawOf(pose.map_from_robot));
  message.twist.twist.linear.x = twist_robot.x_mps;
  message.twist.twist.linear.y = twist_robot.y_mps;
  message.twist.twist.angular.z = twist_robot.turn_radps;
  message.twist.covariance[diagonal(0)] = velocity.linear_variance;
  message.twist.covariance[diagonal(1)] = velocity.linear_variance;
  message.twist.covariance[diagonal(5)] = velocity.angular_variance;
  return message;
}

}  // namespace sylph_mocap_bridge
