#pragma once

#include <ros/console.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "sylph_ros/parameter_reader.hpp"

namespace sylph_ros {

/// Prints a node's parameters as rows of a table, if that is what the command line asks for.
/// @param read  reads them from a ParameterReader&
/// @return whether they were asked for, by `--parameters`
template <typename Read>
bool printParameters(int argc, char** argv, const Read& read) {
  if (argc != 2 || std::string(argv[1]) != "--parameters") {
    return false;
  }
  ParameterReader reader;
  read(reader);
  std::cout << reader.table();
  return true;
}

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

/// The whole of a node's main(). With `--parameters` it prints those and does nothing else.
/// @param read  as of printParameters()
template <typename Node, typename Read>
int runNode(int argc, char** argv, const std::string& name, const Read& read) {
  if (printParameters(argc, argv, read)) {
    return EXIT_SUCCESS;
  }
  initNode(argc, argv, name);
  return spinNode<Node>();
}

}  // namespace sylph_ros
