#pragma once

#include <ros/node_handle.h>

namespace sylph_planner_node {

/// Parameters of sylph_planner besides those of sylph_ros::loadExperiment().
struct Options {
  double tick_period_s = 0.05;     ///< of the mission's state machine [s], > 0
  double feedback_period_s = 0.5;  ///< of the action's feedback [s], > 0
  double map_period_s = 2.0;       ///< between two repetitions of /map [s], > 0
  double resend_period_s = 0.5;    ///< before a plan that did not arrive is sent again [s], > 0
  double pose_timeout_s = 0.5;     ///< a pose that came earlier is stale [s], > 0
  double pose_wait_s = 5.0;        ///< wall time for poses to come when a mission starts [s], > 0
  double central_wait_s = 10.0;    ///< wall time for the central node to be heard of [s], > 0
  double hold_wait_s = 10.0;       ///< for robots to hold after a cancellation [s], > 0
  double replanning_time_limit_s = 1.0;  ///< wall time for a plan around lost robots [s], > 0
  bool ignore_unseen_robots = false;     ///< plan although a robot without part in it is not seen
};

/// @throws std::runtime_error on an unknown, mistyped or forbidden value
Options loadOptions(const ros::NodeHandle& private_nh);

}  // namespace sylph_planner_node
