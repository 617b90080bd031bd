#pragma once

#include <ros/console.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include <cstdlib>
#include <exception>
#include <string>

namespace sylph_ros {

/// ros::init() with the clock and the transforms of the node's fleet: what ROS calls `/clock`,
/// `/use_sim_time`, `/tf` and `/tf_static` is below the fleet's namespace, unless it is remapped
/// already. So fleets on one master have each its own time and its own frames.
void initNode(int argc, char** argv, const std::string& name);

/// Builds the node, spins, and turns a bad start into one line and a failing exit status.
/// @tparam Node  constructible from (ros::NodeHandle nh, ros::NodeHandle private_nh)
template <typename Node>
int spinNode() {
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

/// The whole of a node's main().
template <typename Node>
int runNode(int argc, char** argv, const std::string& name) {
  initNode(argc, argv, name);
  return spinNode<Node>();
}

}  // namespace sylph_ros
