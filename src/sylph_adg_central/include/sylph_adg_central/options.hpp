#pragma once

#include <ros/node_handle.h>

#include <string>

#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_ros/parameter_reader.hpp"

namespace sylph_adg_central {

/// Settings of the central node. Times are seconds of the lab, which pass faster in a simulation.
struct CentralOptions {
  sylph::ExecutionLimits limits;
  double heartbeat_period_s = 0.1;  ///< AdgState at least so often
  bool align = false;  ///< robots that stand off the middle of their starts are aligned first
};

/// Parameters of sylph_adg_central, with meaning and bounds.
/// @throws std::runtime_error with one line on a bad parameter
CentralOptions readCentralOptions(sylph_ros::ParameterReader& reader);

/// @throws std::runtime_error with one line on a bad or unknown parameter
CentralOptions loadCentralOptions(const ros::NodeHandle& private_nh,
                                  const sylph::Experiment& experiment);

}  // namespace sylph_adg_central
