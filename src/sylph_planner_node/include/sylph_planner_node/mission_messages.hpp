#pragma once

#include <sylph_msgs/ExecuteMissionAction.h>

#include "sylph_planner_node/mission.hpp"
#include "sylph_planner_node/progress.hpp"

/// Missions on the wire.
namespace sylph_planner_node {

sylph_msgs::ExecuteMissionFeedback toMessage(const MissionProgress& progress);
sylph_msgs::ExecuteMissionResult toMessage(const MissionResult& result);

}  // namespace sylph_planner_node
