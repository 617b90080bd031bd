#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"
#include "sylph_core/policy/policy.hpp"

namespace sylph {

/// How a mission ends, see ExecuteMission.action.
enum class MissionOutcome : std::uint8_t {
  Success = 0,
  BadRequest = 1,
  NoPose = 2,
  NoPlan = 3,
  PlanRefused = 4,
  Preempted = 5,
  Incomplete = 6,
};

/// Why a mission ends without success, in one line for the operator.
class MissionFailure : public std::runtime_error {
 public:
  /// @param message  one line, without the mission's or the planner's name
  MissionFailure(MissionOutcome outcome, const std::string& message)
      : std::runtime_error(message), outcome_(outcome) {}
  MissionOutcome outcome() const { return outcome_; }

 private:
  MissionOutcome outcome_;
};

/// How a mission went, see ExecuteMission.action.
struct MissionResult {
  MissionOutcome outcome = MissionOutcome::Success;
  std::string message;  ///< how it ended, for the operator
  std::uint32_t robots = 0;
  std::uint32_t arrived = 0;       ///< robots on their goals
  std::uint32_t plan_steps = 0;    ///< joint actions of the last plan
  std::uint32_t sum_of_costs = 0;  ///< of that plan [timesteps]
  double planning_s = 0.0;         ///< all plans together, by the clock of their time limits [s]
  double execution_s = 0.0;        ///< from the first task to the last arrival [s]
  std::uint32_t replans = 0;       ///< plans around lost robots
};

/// A mission that has been checked as far as it can be without knowing where the robots are.
struct Mission {
  std::string map_path;  ///< for messages
  Grid grid;
  double cell_size_m = 0.0;  ///< side of a cell [m], > 0
  Point corner;              ///< lower left corner of the map [m]
  std::vector<std::string> robots;
  Configuration goals;                   ///< one per robot, free and distinct
  std::string planner;                   ///< its name, as makePlanner() knows it
  std::shared_ptr<const Policy> policy;  ///< for planners that need one
  double time_limit_s = 0.0;             ///< for a plan [s], > 0
  /// So many steps of the planner's search are its second, so that a plan does not depend on how
  /// fast a machine is; 0: seconds are those of the wall.
  double search_steps_per_s = 0.0;
  bool first_solution_only = false;  ///< no improvement
  std::uint32_t seed = 0;            ///< of the planner

  /// Index of a robot, or robots.size() if it has no part in the mission.
  std::size_t indexOf(const std::string& robot) const {
    return static_cast<std::size_t>(std::find(robots.begin(), robots.end(), robot) -
                                    robots.begin());
  }
};

/// The experiment's own mission: all of its robots to their goals, with its planner, time limit and
/// seed.
/// @param policy  for planners that need one; whether it is missing is seen when they plan
Mission toMission(const Experiment& experiment, std::shared_ptr<const Policy> policy = nullptr);

}  // namespace sylph
