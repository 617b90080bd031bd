#pragma once

#include <string>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// A plan that checkPlan() has accepted.
struct CheckedPlan {
  Instance instance;
  Plan plan;                        ///< checked against `instance`
  std::vector<SocialState> social;  ///< one per joint action
  PlanMetrics metrics;              ///< of `plan`
  double planning_s = 0.0;          ///< by the clock of the mission's time limit [s]
};

/// The plan as it goes to the central node; its ids are left to the caller.
/// @param robots  name of each agent
MissionPlan toMissionPlan(const CheckedPlan& plan, const std::vector<std::string>& robots,
                          const std::string& planner);

/// The instance of a mission: rotations are ruled out, since robots hold the cell that they leave
/// until they have arrived in the next one.
/// @throws MissionFailure (BadRequest) naming the robot whose goal cannot be reached or is taken
/// by an obstacle
Instance toInstance(const Mission& mission, const Configuration& starts,
                    const std::vector<Cell>& obstacles);

/// Plans and checks. Takes as long as the mission's time limit: meant for a thread of its own.
/// @throws MissionFailure (NoPlan) if there is none or checkPlan() finds fault with it
CheckedPlan planMission(const Mission& mission, const Instance& instance);

/// As planMission(), but where there is no plan to all goals it goes as far as the planner came,
/// at worst nowhere: the goals of the returned instance are then where the plan ends.
/// @throws MissionFailure (NoPlan) if checkPlan() finds fault with it
CheckedPlan planAsFarAsPossible(const Mission& mission, const Instance& instance);

}  // namespace sylph
