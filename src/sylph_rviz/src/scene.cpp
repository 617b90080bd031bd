#include "sylph_rviz/scene.hpp"

#include <sylph_msgs/Task.h>
#include <sylph_msgs/TaskReport.h>

#include <algorithm>
#include <set>

#include "sylph_ros/conversions.hpp"

namespace sylph_rviz {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

namespace {

/// Between two points of what a robot has driven.
constexpr double kDrivenStepM = 0.02;
/// 100 m; what is driven after that is not kept.
constexpr std::size_t kMaxDriven = 5000;

bool beginsAnew(const AdgState& state, const AdgState& before) {
  return state.plan_id != 0 &&
         (state.plan_id != before.plan_id || state.elapsed_s < before.elapsed_s);
}

}  // namespace

void setState(Scene& scene, const AdgState& state) {
  if (scene.state && beginsAnew(state, *scene.state)) {
    for (RobotView& view : scene.robots) {
      view.driven.clear();
    }
  }
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

void setPose(RobotView& robot, const sylph::Pose2d& pose) {
  robot.pose = pose;
  const sylph::Point position = sylph::position(pose);
  const bool is_new =
      robot.driven.empty() || sylph::distance(robot.driven.back(), position) >= kDrivenStepM;
  if (is_new && robot.driven.size() < kMaxDriven) {
    robot.driven.push_back(position);
  }
}

std::optional<sylph::Point> centerOf(const Scene& scene, const sylph::Cell& cell) {
  if (!scene.map) {
    return std::nullopt;
  }
  return sylph::CellFrame(scene.map->rows, scene.map->cell_size_m, scene.map->corner).toPoint(cell);
}

std::optional<sylph::Cell> cellOf(const RobotExecution& robot) {
  if (robot.remaining_path.empty()) {
    return std::nullopt;
  }
  return sylph_ros::fromMessage(robot.cell);
}

const RobotView* findRobot(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.robots.begin(), scene.robots.end(),
                                  [&](const RobotView& robot) { return robot.name == name; });
  return found == scene.robots.end() ? nullptr : &*found;
}

std::vector<const RobotView*> waitChain(const Scene& scene, const std::string& name) {
  std::vector<const RobotView*> chain;
  const RobotView* robot = findRobot(scene, name);
  while (robot != nullptr && std::find(chain.begin(), chain.end(), robot) == chain.end()) {
    chain.push_back(robot);
    const bool waits = robot->execution && robot->execution->waiting != 0;
    robot = waits ? findRobot(scene, robot->execution->waits_for_robot) : nullptr;
  }
  return chain;
}

std::vector<bool> inFront(const Scene& scene) {
  const bool is_crowd = scene.robots.size() > kCrowd;
  std::set<std::string> names = {scene.selected};
  for (const RobotView& robot : scene.robots) {
    if (!robot.execution) {
      continue;
    }
    const RobotExecution& execution = *robot.execution;
    if (robot.name == scene.selected) {
      names.insert(execution.partner);
    }
    if (execution.condition != RobotExecution::OK) {
      names.insert(robot.name);
    }
    if (execution.waiting != 0) {
      names.insert({robot.name, execution.waits_for_robot, execution.root_cause_robot});
    }
  }
  std::vector<bool> in_front;
  in_front.reserve(scene.robots.size());
  for (const RobotView& robot : scene.robots) {
    in_front.push_back(!is_crowd || names.count(robot.name) > 0);
  }
  return in_front;
}

std::vector<sylph::Cell> pathOf(const sylph::MissionPlan& plan, std::size_t agent) {
  std::vector<sylph::Cell> path;
  for (const sylph::Configuration& configuration : plan.plan) {
    if (path.empty() || path.back() != configuration[agent]) {
      path.push_back(configuration[agent]);
    }
  }
  return path;
}

bool isBusy(const AdgState& state) {
  return state.phase == AdgState::PENDING || state.phase == AdgState::EXECUTING ||
         state.phase == AdgState::CUTTING || state.phase == AdgState::AT_CUT;
}

std::vector<sylph::Cell> plannedPath(const Scene& scene, const RobotView& robot) {
  if (!scene.state || !robot.execution) {
    return {};
  }
  if (scene.plan && scene.plan->plan_id == scene.state->plan_id) {
    const std::vector<std::string>& names = scene.plan->robots;
    const auto agent = std::find(names.begin(), names.end(), robot.name);
    return agent == names.end()
               ? std::vector<sylph::Cell>{}
               : pathOf(*scene.plan, static_cast<std::size_t>(agent - names.begin()));
  }
  std::vector<sylph::Cell> path;
  for (const sylph_msgs::Cell& cell : robot.execution->remaining_path) {
    path.push_back(sylph_ros::fromMessage(cell));
  }
  return path;
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
