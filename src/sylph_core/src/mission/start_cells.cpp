#include "sylph_core/mission/start_cells.hpp"

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "sylph_core/grid/cell_frame.hpp"

namespace sylph {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw MissionFailure(MissionOutcome::NoPose, message);
}

std::string metres(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

/// Adds the robot's cell to `cells` and `owner`.
/// @return why it has none that a plan can start from; empty: it has
std::string reasonForNoCell(const Mission& mission, const std::string& robot,
                            const RobotPoses& poses, const CellFrame& frame,
                            std::map<Cell, std::string>& owner, Configuration& cells) {
  const auto measured = poses.find(robot);
  if (measured == poses.end()) {
    return "no pose of " + robot + " has come";
  }
  if (!measured->second.fault.empty()) {
    return "the pose of " + robot + " " + measured->second.fault;
  }
  const Point position = sylph::position(measured->second.pose);
  const Cell cell = frame.toCell(position);
  const std::string where = robot + " at (" + metres(position.x) + ", " + metres(position.y) +
                            ") m is in cell " + toString(cell);
  if (!mission.grid.isInside(cell)) {
    return where + ", outside the map";
  }
  if (!mission.grid.isFree(cell)) {
    return where + ", which is an obstacle";
  }
  const auto [other, is_new] = owner.emplace(cell, robot);
  if (!is_new) {
    return where + ", where " + other->second + " is too";
  }
  cells.push_back(cell);
  return {};
}

}  // namespace

Configuration startCells(const Mission& mission, const RobotPoses& poses) {
  const CellFrame frame(mission.grid, mission.cell_size_m, mission.corner);
  std::map<Cell, std::string> owner;
  Configuration cells;
  std::string reasons;
  for (const std::string& robot : mission.robots) {
    const std::string reason = reasonForNoCell(mission, robot, poses, frame, owner, cells);
    reasons += reasons.empty() || reason.empty() ? reason : "\n" + reason;
  }
  if (!reasons.empty()) {
    refuse(reasons);
  }
  return cells;
}

std::vector<std::string> unseenBystanders(const Mission& mission, const std::vector<RobotSpec>& lab,
                                          const RobotPoses& poses) {
  std::vector<std::string> unseen;
  for (const RobotSpec& robot : lab) {
    const auto measured = poses.find(robot.name);
    const bool is_seen = measured != poses.end() && measured->second.fault.empty();
    if (mission.indexOf(robot.name) == mission.robots.size() && !is_seen) {
      unseen.push_back(robot.name + " has no part in the mission, but might stand in its way: " +
                       (measured == poses.end() ? "no pose of it has come"
                                                : "its pose " + measured->second.fault));
    }
  }
  return unseen;
}

CellOwners cellsOfBystanders(const Mission& mission, const std::vector<RobotSpec>& lab,
                             const RobotPoses& poses, double distance_m) {
  const CellFrame frame(mission.grid, mission.cell_size_m, mission.corner);
  CellOwners cells;
  for (const RobotSpec& robot : lab) {
    const auto measured = poses.find(robot.name);
    if (mission.indexOf(robot.name) < mission.robots.size() || measured == poses.end() ||
        !measured->second.fault.empty()) {
      continue;
    }
    const Pose2d& pose = measured->second.pose;
    const Vector2 margin{distance_m, distance_m};
    for (const Cell& cell : frame.cellsUnder(
             position(pose), halfBox(robot.length_m, robot.width_m, pose.yaw_rad) + margin)) {
      if (mission.grid.isInside(cell)) {
        cells.emplace(cell, robot.name);
      }
    }
  }
  return cells;
}

}  // namespace sylph
