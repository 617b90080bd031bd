#pragma once

#include "sylph_ros/parameter_reader.hpp"

namespace sylph_rviz {

/// Parameters of sylph_markers, beside the experiment's (sylph_ros::loadExperiment()).
struct Options {
  double rate_hz = 10.0;        ///< how often a layer that is looked at is sent
  double lifetime_s = 2.0;      ///< after this long without a message markers vanish
  double pose_timeout_s = 0.5;  ///< a pose so much older than the newest input is faint
};

/// Meaning and bounds of each.
/// @throws std::runtime_error on a bad parameter
Options readOptions(sylph_ros::ParameterReader& reader);

}  // namespace sylph_rviz
