#pragma once

#include "sylph_ros/parameter_reader.hpp"

namespace sylph_rviz {

/// Parameters of sylph_markers, beside the experiment's (sylph_ros::loadExperiment()).
struct Options {
  double rate_hz = 10.0;
  double lifetime_s = 2.0;
  double pose_timeout_s = 0.5;
};

/// Meaning and bounds of each.
/// @throws std::runtime_error on a bad parameter
Options readOptions(sylph_ros::ParameterReader& reader);

}  // namespace sylph_rviz
