#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/mission/robot_goals.hpp"

namespace sylph_planner_node {

/// What sylph_send was asked for.
struct SendRequest {
  sylph::RobotGoals goals;       ///< one or more
  bool others_give_way = false;  ///< robots without a goal take part: to the cells they stand in
  bool replaces = false;         ///< a mission that is under way may be ended for this one
  bool plan_only = false;        ///< the plan is shown, and nothing moves
  std::string save_path;         ///< of the experiment file to write; empty: none
  std::optional<std::string> planner;  ///< its name; nothing: the lab's
  std::optional<double> time_limit_s;  ///< for planning [s], > 0; nothing: the lab's
  std::optional<std::uint32_t> seed;   ///< of the planner; nothing: the lab's
  double wait_s = 10.0;                ///< wall time for planner and poses to appear [s]
};

/// Reads arguments such as "robot_3:=4,7": the robot's name, row and column of its goal.
/// @throws std::invalid_argument with one line if one has another form, its robot is not of the
/// lab or is named twice, or GoalJudge refuses its goal on the lab's map
sylph::RobotGoals readGoals(const std::vector<std::string>& arguments,
                            const sylph::Experiment& lab);

/// The mission as an experiment, with all robots of `lab`: those without a goal stay.
/// @param lab    or those of its robots that have part in the mission
/// @param cells  where its robots are, in their order
sylph::Experiment toExperiment(const SendRequest& request, const sylph::Experiment& lab,
                               const sylph::Configuration& cells);

}  // namespace sylph_planner_node
