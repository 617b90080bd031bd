#pragma once

#include <map>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/mission/goal_judge.hpp"
#include "sylph_core/mission/mission.hpp"

namespace sylph {

/// The last pose of a robot.
struct RobotPose {
  Pose2d pose;        ///< the robot's frame in the map
  std::string fault;  ///< why it cannot be used, to follow "the pose of robot_3 "; empty: nothing
};

/// By name of the robot.
using RobotPoses = std::map<std::string, RobotPose>;

/// The cells in which the robots of a mission are, one per robot: the cell that contains the pose.
/// @throws MissionFailure (NoPose) with one line per robot whose pose is missing or faulty, not in
/// a free cell, or in the cell of another robot
Configuration startCells(const Mission& mission, const RobotPoses& poses);

/// Robots through which a plan might lead since nobody sees them: one line per robot of the lab
/// without part in the mission whose pose is missing or faulty.
std::vector<std::string> unseenBystanders(const Mission& mission, const std::vector<RobotSpec>& lab,
                                          const RobotPoses& poses);

/// The cells that robots of the lab without part in the mission stand on, as far as they have good
/// poses, and who does: obstacles for everybody else. A footprint that reaches over an edge takes
/// the cells on both sides.
/// @param distance_m  a cell is stood on too if the footprint is so near to it, >= 0
CellOwners cellsOfBystanders(const Mission& mission, const std::vector<RobotSpec>& lab,
                             const RobotPoses& poses, double distance_m);

}  // namespace sylph
