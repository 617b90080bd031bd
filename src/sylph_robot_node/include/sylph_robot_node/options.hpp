#pragma once

#include <ros/node_handle.h>

#include <string>

#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_ros/parameter_reader.hpp"

namespace sylph_robot_node {

/// Parameters of the node; README.md has the same rows. What all nodes share comes from the
/// experiment.
struct Options {
  std::string robot;       ///< its name, which is its namespace and frame
  std::string experiment;  ///< absolute path
  double control_rate_hz = 50.0;
  double report_rate_hz = 10.0;
  bool poses_by_udp = false;                 ///< rather than by TCP
  double shutdown_s = 0.5;                   ///< zeros sent before the node goes down
  sylph::RobotControllerOptions controller;  ///< limits of the experiment
  sylph::Grid grid;                          ///< the experiment's map
  double cell_size_m = 0.0;
  sylph::Point corner;  ///< lower left corner of the map [m]
};

/// The node's own parameters, with meaning and bounds.
/// @throws std::runtime_error on a mistyped or forbidden value
Options readOptions(sylph_ros::ParameterReader& reader);

/// @throws std::runtime_error naming the parameter if one is unknown, of the wrong type or out of
/// its bounds, if the experiment cannot be read, or if the robot is not in it
Options loadOptions(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

}  // namespace sylph_robot_node
