#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <sylph_msgs/ExecuteMissionGoal.h>

#include <cstdint>
#include <string>

#include "sylph_core/experiment/experiment.hpp"

/// What those who send missions have in common.
namespace sylph_ros {

/// The mission of an experiment: all its robots to their goals.
sylph_msgs::ExecuteMissionGoal toGoal(const sylph::Experiment& experiment);

/// Whether a mission is planned or carried out, by the status of an ExecuteMission action.
bool isUnderWay(const actionlib_msgs::GoalStatusArray& status);

/// Name of an outcome of ExecuteMissionResult, e.g. "NO_POSE".
std::string outcomeName(std::uint8_t outcome);

}  // namespace sylph_ros
