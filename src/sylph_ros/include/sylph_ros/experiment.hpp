#pragma once

#include <ros/node_handle.h>

#include <string>

#include "sylph_core/experiment/experiment.hpp"

namespace sylph_ros {

/// The experiment that a fleet runs, by the parameters `experiment`, `seed`, `planner` and
/// `weights` of the suite's namespace.
/// @param suite_nh  in the suite's namespace
/// @param own_path  of a copy of the experiment on this computer, takes the place of the parameter
/// @throws std::runtime_error as sylph::loadExperiment() or on a bad parameter
sylph::Experiment loadExperiment(const ros::NodeHandle& suite_nh, const std::string& own_path = "");

}  // namespace sylph_ros
