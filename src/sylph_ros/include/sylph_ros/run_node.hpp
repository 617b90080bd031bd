#pragma once

#include <ros/console.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include <cstdlib>
#include <exception>
#include <string>

namespace sylph_ros {

/// The whole of a node's main(): starts ROS, builds the node, spins, and turns a bad start into one
/// line and a failing exit status.
/// @tparam Node  constructible from (ros::NodeHandle nh, ros::NodeHandle private_nh)
template <typename Node>
int runNode(int argc, char** argv, const std::string& name) {
  ros::init(argc, argv, name);
  // The last handle that goes shuts ROS down, and then nothing is printed any more.
  const ros::NodeHandle nh;
  try {
    Node node(nh, ros::NodeHandle("~"));
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace sylph_ros
