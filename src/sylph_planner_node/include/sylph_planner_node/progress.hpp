#pragma once

#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/ExecuteMissionAction.h>

#include <string>
#include <vector>

#include "sylph_planner_node/mission.hpp"

namespace sylph_planner_node {

/// One line per robot that does not move although it has something to do: who waits for whom, for
/// how long and why. A pause or stop of the whole lab is the first line.
std::vector<std::string> waitingLines(const sylph_msgs::AdgState& state);

/// Robots of the mission that have done all their tasks and stand on their goal.
std::uint32_t robotsArrived(const Mission& mission, const sylph_msgs::AdgState& state);

/// @param phase  what the planner node does; the rest is taken from `state`
sylph_msgs::ExecuteMissionFeedback toFeedback(const std::string& phase, const Mission& mission,
                                              const sylph_msgs::AdgState& state);

/// Result of a mission whose last plan is FINISHED: SUCCESS if everybody is on its goal, otherwise
/// INCOMPLETE with one clause per robot that is not.
/// @param given_up  why robots could not have their goals, from restOfMission()
sylph_msgs::ExecuteMissionResult finishedResult(const Mission& mission,
                                                const sylph_msgs::AdgState& state,
                                                const std::vector<std::string>& given_up);

/// Whether `state` is that of a plan of this mission that is being carried out: the same robots
/// with the same goals. A planner that was started again goes on with it.
bool isExecutionOf(const Mission& mission, const sylph_msgs::AdgState& state);

/// Whether some plan is under way.
bool isBusy(const sylph_msgs::AdgState& state);

/// Whether no robot moves or will move before the central node releases new tasks.
bool allHold(const sylph_msgs::AdgState& state);

}  // namespace sylph_planner_node
