#pragma once

#include "sylph_ros/parameter_reader.hpp"

namespace sylph_planner_node {

/// Parameters of sylph_planner besides those of sylph_ros::loadExperiment(). Meaning and bounds are
/// in readOptions() and in README.md.
struct Options {
  double tick_period_s = 0.05;           ///< of the mission's state machine
  double feedback_period_s = 0.5;        ///< of the action's feedback
  double map_period_s = 2.0;             ///< between two repetitions of /map
  double resend_period_s = 0.5;          ///< before a plan that did not arrive is sent again
  double pose_timeout_s = 0.5;           ///< a pose that came earlier is stale
  double pose_wait_s = 5.0;              ///< wall time for poses to come when a mission starts
  double central_wait_s = 10.0;          ///< wall time for the central node to be heard of
  double hold_wait_s = 10.0;             ///< for robots to hold after a cancellation
  double replanning_time_limit_s = 1.0;  ///< wall time for a plan around lost robots
  bool ignore_unseen_robots = false;     ///< plan although a robot without part is not seen
};

/// @throws std::runtime_error on a mistyped or forbidden value
Options readOptions(sylph_ros::ParameterReader& reader);

}  // namespace sylph_planner_node
