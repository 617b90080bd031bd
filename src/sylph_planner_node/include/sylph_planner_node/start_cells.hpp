#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <map>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_planner_node/mission.hpp"

namespace sylph_planner_node {

/// The last pose of one robot and when it came.
struct MeasuredPose {
  geometry_msgs::PoseStamped pose;
  double received_s = 0.0;  ///< steady time [s]
};

using MeasuredPoses = std::map<std::string, MeasuredPose>;

/// The cells in which the robots of a mission are, one per robot: the cell that contains the pose.
/// @param now_s      steady time [s]
/// @param timeout_s  a pose that came earlier is stale [s]
/// @throws MissionFailure (NO_POSE) naming the robot whose pose is missing or faulty
/// (judgePose()), not in a free cell, or in the cell of another robot
sylph::Configuration startCells(const Mission& mission, const MeasuredPoses& poses, double now_s,
                                double timeout_s);

/// The cells that robots of the lab without part in the mission stand on, by fresh poses: obstacles
/// for everybody else. A footprint that reaches over an edge takes the cells on both sides.
std::vector<sylph::Cell> cellsOfBystanders(const Mission& mission, const sylph::Experiment& lab,
                                           const MeasuredPoses& poses, double now_s,
                                           double timeout_s);

}  // namespace sylph_planner_node
