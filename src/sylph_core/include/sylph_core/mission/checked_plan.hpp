#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/mission/goal_judge.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/mission/start_cells.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// A plan that checkPlan() has accepted.
struct CheckedPlan {
  Instance instance;
  Plan plan;                               ///< checked against `instance`
  std::vector<SocialState> social;         ///< one per joint action
  PlanMetrics metrics;                     ///< of `plan`
  std::optional<long> least_sum_of_costs;  ///< no plan has less, as far as the planner looked
  double planning_s = 0.0;                 ///< by the clock of the mission's time limit [s]
};

/// What a plan costs, and how far from the least that may be: "sum of costs 94, at most 2 % above
/// the least".
std::string ratedCostOf(const CheckedPlan& plan);

/// What a plan costs and what checkPlan() vouches for, in one line for the operator.
std::string certificateOf(const CheckedPlan& plan);

/// The plan as it goes to the central node; its ids are left to the caller.
/// @param robots  name of each agent
MissionPlan toMissionPlan(const CheckedPlan& plan, const std::vector<std::string>& robots,
                          const std::string& planner);

/// The instance of a mission: rotations are ruled out, since robots hold the cell that they leave
/// until they have arrived in the next one.
/// @param bystanders  cells of robots without part in it, obstacles for its own
/// @throws MissionFailure (BadRequest) with what GoalJudge says, (NoPose) naming the robot that
/// touches a bystander's cell
Instance toInstance(const Mission& mission, const Configuration& starts,
                    const CellOwners& bystanders);

/// What a mission begins with, by the poses of the robots.
struct MissionStart {
  Instance instance;
  CellOwners bystanders;  ///< cells of robots without part in the mission, obstacles in `instance`
  std::vector<std::string> unseen;  ///< what unseenBystanders() says of those that are ignored
};

/// @param lab                    robots that there are
/// @param ignores_unseen_robots  goes on although one without part in the mission is not seen
/// @param bystander_distance_m   as cellsOfBystanders() has it
/// @throws MissionFailure (NoPose, BadRequest) as startCells() and toInstance(), or with what
/// unseenBystanders() says
MissionStart startOf(const Mission& mission, const std::vector<RobotSpec>& lab,
                     const RobotPoses& poses, bool ignores_unseen_robots,
                     double bystander_distance_m);

/// A plan that was shown before anybody moved, for robots that stand where they stand now.
/// @param plan  of this mission
/// @throws MissionFailure (BadRequest) with the robot that stands elsewhere, or with what
/// checkPlan() says, if it does not fit any more
CheckedPlan stillFitting(const Mission& mission, const Instance& instance, const CheckedPlan& plan);

/// Plans and checks. Takes as long as the mission's time limit: meant for a thread of its own.
/// @throws MissionFailure (NoPlan) if there is none or checkPlan() finds fault with it
CheckedPlan planMission(const Mission& mission, const Instance& instance);

/// As planMission(), but where there is no plan to all goals it goes as far as the planner came,
/// at worst nowhere: the goals of the returned instance are then where the plan ends.
/// @throws MissionFailure (NoPlan) if checkPlan() finds fault with it
CheckedPlan planAsFarAsPossible(const Mission& mission, const Instance& instance);

}  // namespace sylph
