#pragma once

#include <string>
#include <vector>

#include "sylph_core/execution/adg_state.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mission/mission.hpp"

namespace sylph {

/// What is left of a mission at the commit cut, for the robots that are not lost.
struct RestOfMission {
  std::vector<std::string> robots;  ///< in the mission's order
  Instance instance;  ///< starts: where they are at the cut; held cells of lost robots are
                      ///< obstacles
  std::vector<std::string> given_up;  ///< one line per robot that cannot have its goal any more
};

/// Keeps each goal that can still be reached. A robot whose goal is held by a lost robot or cut off
/// by one gets the free cell next to it that it can reach and nobody else wants.
/// @throws MissionFailure (PlanRefused) if `cut` does not tell where each robot is, or all are
/// lost
RestOfMission restOfMission(const Mission& mission, const AdgState& cut);

}  // namespace sylph
