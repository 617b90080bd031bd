#pragma once

#include <sylph_msgs/ExecuteMissionAction.h>

#include <optional>
#include <string>

#include "sylph_core/execution/mission_plan.hpp"

/// What sylph_mission tells the operator.
namespace sylph_planner_node {

/// One line, e.g. "executing: 31 of 120 tasks, 2 of 8 robots arrived", and one more, indented, per
/// robot that waits.
std::string progressText(const sylph_msgs::ExecuteMissionFeedback& feedback, std::size_t robots);

/// Several lines: outcome, message, figures.
std::string resultText(const sylph_msgs::ExecuteMissionResult& result);

/// One line per robot: from where to where, how many moves, when it arrives.
std::string waysText(const sylph::MissionPlan& plan);

}  // namespace sylph_planner_node
