#pragma once

#include "sylph_core/mission/mission_lifecycle.hpp"
#include "sylph_ros/parameter_reader.hpp"

namespace sylph_planner_node {

/// Parameters of sylph_planner besides those of sylph_ros::loadExperiment(). Meaning and bounds are
/// in readOptions() and in README.md.
struct Options {
  double tick_period_s = 0.05;      ///< of the mission's state machine
  double feedback_period_s = 0.5;   ///< of the action's feedback
  double map_period_s = 2.0;        ///< between two repetitions of /map
  double pose_timeout_s = 0.5;      ///< a pose that came earlier is stale
  double search_steps_per_s = 0.0;  ///< see sylph::Mission
  sylph::MissionLimits limits;      ///< waits for poses and the central node in wall time
};

/// @throws std::runtime_error on a mistyped or forbidden value
Options readOptions(sylph_ros::ParameterReader& reader);

}  // namespace sylph_planner_node
