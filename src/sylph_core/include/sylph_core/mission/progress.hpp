#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/execution/adg_state.hpp"
#include "sylph_core/mission/mission.hpp"

namespace sylph {

/// How far a mission is, for those who wait for it.
struct MissionProgress {
  std::string phase;                 ///< planning, sending, executing, ...
  std::uint32_t tasks_done = 0;      ///< of all robots, by the present plan
  std::uint32_t tasks_total = 0;     ///< of all robots, in the present plan
  std::uint32_t robots_arrived = 0;  ///< see robotsArrived()
  std::vector<std::string> waiting;  ///< see waitingLines()
};

/// One line per robot that does not move although it has something to do: who waits for whom, for
/// how long and why. A pause or stop of the whole lab is the first line.
std::vector<std::string> waitingLines(const AdgState& state);

/// Robots of the mission that have done all their tasks and stand on their goal.
std::uint32_t robotsArrived(const Mission& mission, const AdgState& state);

/// @param phase  of the mission; the rest is taken from `state`
MissionProgress progressOf(const std::string& phase, const Mission& mission, const AdgState& state);

/// Result of a mission whose last plan is FINISHED: SUCCESS if everybody is on its goal, otherwise
/// INCOMPLETE with one clause per robot that is not.
/// @param given_up  why robots could not have their goals, from restOfMission()
MissionResult finishedResult(const Mission& mission, const AdgState& state,
                             const std::vector<std::string>& given_up);

/// Whether `state` is that of a plan of this mission that is being carried out: the same robots
/// with the same goals. A planner that was started again goes on with it.
bool isExecutionOf(const Mission& mission, const AdgState& state);

/// Whether some plan is under way.
bool isBusy(const AdgState& state);

/// Whether no robot moves or will move before the central node releases new tasks.
bool allHold(const AdgState& state);

}  // namespace sylph
