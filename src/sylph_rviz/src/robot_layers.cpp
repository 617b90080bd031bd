#include <cmath>

#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

constexpr double kGoalRadiusM = 0.13;
constexpr double kStaleAlpha = 0.4;
constexpr std::size_t kLanes = 8;
constexpr double kLaneM = 0.018;  // from lane to lane

std::optional<sylph::Cell> goalOf(const RobotView& robot, bool has_plan) {
  if (has_plan && robot.execution && cellOf(*robot.execution)) {
    return sylph::Cell{robot.execution->goal.row, robot.execution->goal.col};
  }
  return robot.goal;
}

/// How far a robot's path lies from the cells' centres, along x and along y [m].
double laneOf(std::size_t index) {
  return (static_cast<double>(index % kLanes) - 0.5 * static_cast<double>(kLanes - 1)) * kLaneM;
}

}  // namespace

Markers robotMarkers(const Scene& scene) {
  Markers markers;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotView& robot = scene.robots[i];
    if (!robot.pose) {
      continue;
    }
    const int id = static_cast<int>(i);
    const auto color = withAlpha(robotColor(i), robot.pose_is_stale ? kStaleAlpha : 1.0);
    const auto ink = robot.pose_is_stale ? white() : textColorOn(robotColor(i));
    markers.push_back(
        attach(box({"body", id}, {0.0, 0.0}, robot.length_m, robot.width_m, height::kBody, color),
               robot, true));
    const double front_m = 0.5 * robot.length_m - 0.015;
    markers.push_back(attach(
        lineList({"front", id}, {{front_m, 0.35 * robot.width_m}, {front_m, -0.35 * robot.width_m}},
                 height::kBody + 0.005, 0.02, withAlpha(ink, 0.6)),
        robot, true));
    markers.push_back(attach(
        text({"name", id}, {0.02, -0.03}, height::kText, 0.12, shortName(robot.name), ink), robot));
  }
  return markers;
}

Markers goalMarkers(const Scene& scene) {
  Markers markers;
  const bool has_plan = scene.state && scene.state->plan_id != 0;
  const std::vector<bool> in_front = inFront(scene);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const auto goal = goalOf(scene.robots[i], has_plan);
    const auto center = goal ? centerOf(scene, *goal) : std::nullopt;
    if (!center) {
      continue;
    }
    const int id = static_cast<int>(i);
    const auto color = withAlpha(robotColor(i), in_front[i] ? 1.0 : kBehindAlpha);
    markers.push_back(ring({"ring", id}, *center, kGoalRadiusM, height::kGoal, 0.025, color));
    markers.push_back(
        text({"name", id}, *center, height::kGoal, 0.12, shortName(scene.robots[i].name), color));
  }
  return markers;
}

Markers pathMarkers(const Scene& scene) {
  Markers markers;
  const std::vector<bool> in_front = inFront(scene);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotView& robot = scene.robots[i];
    if (!robot.pose || !robot.execution || robot.execution->remaining_path.size() < 2) {
      continue;
    }
    const double lane_m = laneOf(i);
    std::vector<sylph::Point> ends = {sylph::position(*robot.pose)};
    // The first cell of the path lies behind the robot or under it.
    for (std::size_t k = 1; k < robot.execution->remaining_path.size(); ++k) {
      const sylph_msgs::Cell& cell = robot.execution->remaining_path[k];
      if (const auto center = centerOf(scene, {cell.row, cell.col})) {
        ends.push_back({center->x + lane_m, center->y + lane_m});
      }
    }
    const auto color = withAlpha(robotColor(i), in_front[i] ? 0.85 : kBehindAlpha);
    const std::vector<sylph::Point> points = pieces(ends);
    if (!points.empty()) {
      markers.push_back(
          lineList({"line", static_cast<int>(i)}, points, height::kPath, 0.018, color));
    }
  }
  return markers;
}

Markers shownPlanMarkers(const Scene& scene) {
  Markers markers;
  if (!scene.shown_plan || (scene.state && isBusy(*scene.state))) {
    return markers;
  }
  for (std::size_t agent = 0; agent < scene.shown_plan->robots.size(); ++agent) {
    const RobotView* robot = findRobot(scene, scene.shown_plan->robots[agent]);
    if (robot == nullptr || !scene.map) {
      continue;
    }
    const auto index = static_cast<std::size_t>(robot - scene.robots.data());
    const int id = static_cast<int>(index);
    const double lane_m = laneOf(index);
    std::vector<sylph::Point> way;
    for (const sylph::Cell& cell : pathOf(*scene.shown_plan, agent)) {
      way.push_back(*centerOf(scene, cell) + sylph::Vector2{lane_m, lane_m});
    }
    const std::vector<sylph::Point> ends = pieces(way);
    const std::vector<sylph::Point> dashed = dashesAlong(ends, 0.05);
    if (dashed.empty()) {
      continue;  // it stays
    }
    markers.push_back(lineList({"line", id}, dashed, height::kDriven, 0.03, robotColor(index)));
    markers.push_back(triangles({"head", id}, arrowHead(ends[ends.size() - 2], ends.back(), 0.12),
                                height::kDriven, robotColor(index)));
    markers.push_back(ring({"ring", id}, *centerOf(scene, scene.shown_plan->goals[agent]),
                           kGoalRadiusM, height::kGoal, 0.025, robotColor(index)));
  }
  return markers;
}

}  // namespace sylph_rviz
