#pragma once

#include <sylph_msgs/JointActions.h>

#include <cstddef>

#include "sylph_core/execution/mission_plan.hpp"

/// A plan on the wire: one message, whole.
namespace sylph_ros {

/// A message holds at most so many actions, agents times steps: about 150 MB. ROS drops a
/// connection over which a message of 1 GB comes, without telling who sent it.
constexpr std::size_t kMaxActions = 4000000;

/// Stamp left to the caller.
/// @throws std::invalid_argument if the plan has more actions than a message holds
sylph_msgs::JointActions toMessage(const sylph::MissionPlan& plan);

/// @throws std::invalid_argument with one line that names step and agent: no agents, lists of
/// different lengths, too many actions, an action that does not lead from where the agent is to
/// where it says
sylph::MissionPlan fromMessage(const sylph_msgs::JointActions& message);

}  // namespace sylph_ros
