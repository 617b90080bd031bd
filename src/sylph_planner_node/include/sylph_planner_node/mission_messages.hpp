#pragma once

#include <sylph_msgs/ExecuteMissionAction.h>

#include "sylph_core/mission/mission.hpp"
#include "sylph_core/mission/progress.hpp"

/// Missions on the wire.
namespace sylph_planner_node {

sylph_msgs::ExecuteMissionFeedback toMessage(const sylph::MissionProgress& progress);
sylph_msgs::ExecuteMissionResult toMessage(const sylph::MissionResult& result);

}  // namespace sylph_planner_node
