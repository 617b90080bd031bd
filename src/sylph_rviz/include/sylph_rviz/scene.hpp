#pragma once

#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/RobotExecution.h>
#include <sylph_msgs/SeparationState.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/cell_frame.hpp"

namespace sylph_rviz {

/// One robot as the layers draw it.
struct RobotView {
  std::string name;                   ///< also its tf frame
  double length_m = 0.23;             ///< footprint along the robot's x axis
  double width_m = 0.20;              ///< footprint along the robot's y axis
  std::optional<sylph::Pose2d> pose;  ///< last measured pose in `map`; nothing before the first
  bool pose_is_stale = false;         ///< drawn faint
  std::optional<sylph::Cell> goal;    ///< where its plan ends
  std::optional<sylph_msgs::RobotExecution> execution;  ///< nothing before the first AdgState
};

/// What the map's extent tells the layers.
struct MapExtent {
  int rows = 0;              ///< cells along y
  int cols = 0;              ///< cells along x
  double cell_size_m = 0.3;  ///< side of a cell
  sylph::Point corner = {};  ///< lower left, in frame `map` [m]
};

/// Everything that the layers are drawn from.
struct Scene {
  std::optional<MapExtent> map;                           ///< nothing before the first map
  std::vector<RobotView> robots;                          ///< the index gives the colour
  std::optional<sylph_msgs::AdgState> state;              ///< the last one
  std::optional<sylph_msgs::SeparationState> separation;  ///< the last one
};

/// Takes over a state of execution: each of its robots is in the scene then, new ones behind those
/// that were there. Robots that it does not name keep their pose and lose what they did.
void setState(Scene& scene, const sylph_msgs::AdgState& state);

/// Centre of a cell, or nothing before the map is known.
std::optional<sylph::Point> centerOf(const Scene& scene, const sylph::Cell& cell);

/// The robot of that name, or nullptr.
const RobotView* findRobot(const Scene& scene, const std::string& name);

/// "3" of "robot_3": what follows the last underscore, or the whole name if nothing does.
std::string shortName(const std::string& name);

/// What a robot is about, from its current task and its condition.
enum class RobotStatus {
  Unknown,   ///< no plan yet
  Enqueued,  ///< its task is released: it drives
  Staged,    ///< its task waits for another robot's
  Done,      ///< all its tasks are DONE: it has arrived
  Held,      ///< paused or stopped
  Fault      ///< silent, stuck, blind or lost
};

/// A fault counts before the mode of execution, that before its task.
RobotStatus statusOf(const sylph_msgs::AdgState& state, const sylph_msgs::RobotExecution& robot);

/// The word for a fault that AdgState gives ("SILENT", ...), empty if there is none.
std::string conditionName(const sylph_msgs::RobotExecution& robot);

}  // namespace sylph_rviz
