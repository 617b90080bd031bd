#pragma once

#include <ros/node_handle.h>

#include "sylph_core/experiment/experiment.hpp"

namespace sylph_ros {

/// The experiment that this node runs: private parameters `experiment` (path, required), `seed`
/// (int, -1: the file's) and `planner` (empty: the file's).
/// @throws std::runtime_error as sylph::loadExperiment() or on a bad parameter
sylph::Experiment loadExperiment(const ros::NodeHandle& private_nh);

}  // namespace sylph_ros
