#pragma once

#include "sylph_ros/parameter_reader.hpp"

namespace sylph_planner_node {

/// Parameters of sylph_planner besides those of sylph_ros::loadExperiment(). Meaning and bounds are
/// in readOptions() and in README.md.
struct Options {
  double tick_period_s = 0.05;
  double feedback_period_s = 0.5;
  double map_period_s = 2.0;
  double resend_period_s = 0.5;
  double pose_timeout_s = 0.5;
  double pose_wait_s = 5.0;
  double central_wait_s = 10.0;
  double hold_wait_s = 10.0;
  double replanning_time_limit_s = 1.0;
  bool ignore_unseen_robots = false;
};

/// @throws std::runtime_error on a mistyped or forbidden value
Options readOptions(sylph_ros::ParameterReader& reader);

}  // namespace sylph_planner_node
