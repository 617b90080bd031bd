#pragma once

#include <ros/node_handle.h>

namespace sylph_rviz {

/// Parameters of sylph_markers, beside the experiment's (sylph_ros::loadExperiment()).
struct Options {
  double rate_hz = 10.0;        ///< how often a layer that is looked at is sent, 1 ... 60
  double lifetime_s = 2.0;      ///< after this long without a message markers vanish, > 1 / rate_hz
  double pose_timeout_s = 0.5;  ///< a pose so much older than the newest input is faint, > 0
};

/// @throws std::runtime_error on an unknown or bad parameter
Options loadOptions(const ros::NodeHandle& private_nh);

}  // namespace sylph_rviz
