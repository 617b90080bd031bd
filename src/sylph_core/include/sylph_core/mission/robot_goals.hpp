#pragma once

#include <map>
#include <string>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Goals that an operator gives some robots of a lab, by the name of their robot.
using RobotGoals = std::map<std::string, Cell>;

/// The mission to these goals as an experiment, with all robots of the lab: those without a goal
/// stay.
/// @param lab    or withParticipants() of it
/// @param cells  where its robots are, in their order
Experiment withGoals(const Experiment& lab, const RobotGoals& goals, const Configuration& cells);

/// Those of its robots that have part in a mission to these goals: all if robots without a goal
/// give way.
Experiment withParticipants(Experiment lab, const RobotGoals& goals, bool others_give_way);

/// "robot_0 to (0,4), robot_2 to (1,1); 6 robots stay".
/// @param robots  that the lab has
std::string headlineOf(const RobotGoals& goals, std::size_t robots, bool others_give_way);

}  // namespace sylph
