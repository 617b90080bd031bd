#pragma once

#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/RobotExecution.h>
#include <sylph_msgs/SeparationState.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"
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
  std::vector<sylph::Point> driven;  ///< where it has been since the plan was begun [m]
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
  std::optional<sylph::MissionPlan> plan;                 ///< the last one, also when it is over
  std::optional<sylph::MissionPlan> shown_plan;           ///< to be looked at before anybody moves
  std::string selected;  ///< the robot that the operator looks at; empty: none
};

/// Takes over a state of execution: each of its robots is in the scene then, new ones behind those
/// that were there. Robots that it does not name keep their pose and lose what they did. With a new
/// plan, and where time has gone back, what robots have driven begins anew.
void setState(Scene& scene, const sylph_msgs::AdgState& state);

/// Takes over a pose, and keeps where the robot has been.
void setPose(RobotView& robot, const sylph::Pose2d& pose);

/// Centre of a cell, or nothing before the map is known.
std::optional<sylph::Point> centerOf(const Scene& scene, const sylph::Cell& cell);

/// The cell in which the central node has a robot; nothing for one that has no part in the mission
/// and of which it has heard no pose: its `cell` and `goal` say nothing then.
std::optional<sylph::Cell> cellOf(const sylph_msgs::RobotExecution& robot);

/// The robot of that name, or nullptr.
const RobotView* findRobot(const Scene& scene, const std::string& name);

/// From a robot to the one that holds it up: each waits for the next, as far as that is known.
/// @return begins with the robot; empty if there is none of that name
std::vector<const RobotView*> waitChain(const Scene& scene, const std::string& name);

/// More robots than these hide each other's signs.
constexpr std::size_t kCrowd = 12;

/// Whom an operator looks for in a crowd: the selected robot and its partner, robots with a fault,
/// those that wait, for whom they wait, and who holds them all up. All where there is no crowd.
/// @return one per robot of the scene
std::vector<bool> inFront(const Scene& scene);

/// The cells of an agent's way in a plan, without waits.
std::vector<sylph::Cell> pathOf(const sylph::MissionPlan& plan, std::size_t agent);

/// Whether a plan is being carried out or about to be.
bool isBusy(const sylph_msgs::AdgState& state);

/// The cells of a robot's way in the present plan, without waits; what is left of it where the plan
/// is not known.
std::vector<sylph::Cell> plannedPath(const Scene& scene, const RobotView& robot);

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
