#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "sylph_rviz/layers.hpp"

namespace sylph_rviz {

/// Two robots on a map of 4 rows and 5 columns: robot_0 in cell (3,0) faces north and goes to
/// (0,0), robot_1 in cell (3,4) has arrived.
inline Scene twoRobots() {
  Scene scene;
  scene.map = MapExtent{4, 5, 0.3};
  scene.state.emplace();
  scene.state->plan_id = 1;
  scene.state->phase = sylph_msgs::AdgState::EXECUTING;
  for (const char* name : {"robot_0", "robot_1"}) {
    RobotView robot;
    robot.name = name;
    robot.execution.emplace();
    robot.execution->robot_id = name;
    scene.robots.push_back(robot);
  }
  RobotView& first = scene.robots[0];
  first.pose = sylph::Pose2d{0.15, 0.15, 1.5707963267948966};
  first.execution->tasks_total = 3;
  first.execution->task_status = 1;
  first.execution->action = 1;
  for (int row = 3; row >= 0; --row) {
    sylph_msgs::Cell cell;
    cell.row = row;
    first.execution->remaining_path.push_back(cell);
  }
  first.execution->cell = first.execution->remaining_path.front();
  first.execution->partner = "robot_1";
  first.execution->svo_deg = 25.0F;
  RobotView& second = scene.robots[1];
  second.pose = sylph::Pose2d{1.35, 0.15, 0.0};
  second.execution->goal.row = 3;
  second.execution->goal.col = 4;
  second.execution->cell = second.execution->goal;
  second.execution->remaining_path = {second.execution->cell};
  second.execution->svo_deg = std::numeric_limits<float>::quiet_NaN();
  scene.state->robots = {*first.execution, *second.execution};
  return scene;
}

/// The marker of that namespace and id, or nullptr.
inline const Marker* findMarker(const Markers& markers, const std::string& ns, int id) {
  const auto found = std::find_if(markers.begin(), markers.end(), [&](const Marker& marker) {
    return marker.ns == ns && marker.id == id;
  });
  return found == markers.end() ? nullptr : &*found;
}

}  // namespace sylph_rviz
