#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>

#include <string>

#include "sylph_mocap_bridge/robot_tracks.hpp"

namespace sylph_mocap_bridge {

/// Position and orientation as they are.
geometry_msgs::Pose toMessage(const Pose& pose);

/// In the frame `map`, stamped at the exposure.
geometry_msgs::PoseStamped toPoseStamped(const ReliablePose& pose);

/// From `map` to the robot's frame.
geometry_msgs::TransformStamped toTransform(const ReliablePose& pose, const std::string& robot);

/// Pose in `map`, twist in the robot's frame, turned by the heading alone. What a robot in the
/// plane does not do (rise, roll, pitch) has velocity 0 and a large variance.
/// @param noise  sigmas of the measured pose
/// @pre pose.velocity
nav_msgs::Odometry toOdometry(const ReliablePose& pose, const std::string& robot,
                              const TrackerOptions& noise);

}  // namespace sylph_mocap_bridge
