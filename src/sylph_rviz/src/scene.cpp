#include "sylph_rviz/scene.hpp"

#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <algorithm>

namespace sylph_rviz {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

void setState(Scene& scene, const AdgState& state) {
  for (RobotView& view : scene.robots) {
    view.execution.reset();
  }
  for (const RobotExecution& robot : state.robots) {
    if (robot.robot_id.empty()) {
      continue;
    }
    auto view = std::find_if(scene.robots.begin(), scene.robots.end(),
                             [&](const RobotView& known) { return known.name == robot.robot_id; });
    if (view == scene.robots.end()) {
      view = scene.robots.emplace(scene.robots.end());
      view->name = robot.robot_id;
    }
    view->execution = robot;
  }
  scene.state = state;
}

std::optional<sylph::Point> centerOf(const Scene& scene, const sylph::Cell& cell) {
  if (!scene.map) {
    return std::nullopt;
  }
  return sylph::CellFrame(scene.map->rows, scene.map->cell_size_m, scene.map->corner).toPoint(cell);
}

const RobotView* findRobot(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.robots.begin(), scene.robots.end(),
                                  [&](const RobotView& robot) { return robot.name == name; });
  return found == scene.robots.end() ? nullptr : &*found;
}

std::string shortName(const std::string& name) {
  const std::size_t underscore = name.rfind('_');
  if (underscore == std::string::npos || underscore + 1 == name.size()) {
    return name;
  }
  return name.substr(underscore + 1);
}

RobotStatus statusOf(const AdgState& state, const RobotExecution& robot) {
  if (robot.condition != RobotExecution::OK) {
    return RobotStatus::Fault;
  }
  if (state.plan_id == 0) {
    return RobotStatus::Unknown;
  }
  if (robot.tasks_done >= robot.tasks_total) {
    return RobotStatus::Done;
  }
  if (state.mode != AdgState::RUN || robot.report_state == sylph_msgs::TaskReport::HOLDING) {
    return RobotStatus::Held;
  }
  if (robot.waiting != 0 || robot.task_status == sylph_msgs::Task::STAGED) {
    return RobotStatus::Staged;
  }
  return RobotStatus::Enqueued;
}

std::string conditionName(const RobotExecution& robot) {
  switch (robot.condition) {
    case RobotExecution::SILENT:
      return "SILENT";
    case RobotExecution::STUCK:
      return "STUCK";
    case RobotExecution::BLIND:
      return "BLIND";
    case RobotExecution::LOST:
      return "LOST";
    default:
      return "";
  }
}

}  // namespace sylph_rviz
