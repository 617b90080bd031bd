#include <sylph_msgs/AgentAction.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sylph_ros/conversions.hpp"
#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

constexpr double kBadgeRadiusM = 0.055;
const sylph::Point kBadgeOffset{-0.075, 0.065};  // on the robot, where its name is not
constexpr double kLongWaitS = 1.0;

std::vector<sylph::Point> shifted(std::vector<sylph::Point> points, const sylph::Point& by) {
  for (sylph::Point& point : points) {
    point = {point.x + by.x, point.y + by.y};
  }
  return points;
}

/// Unit vector in the map of an AgentAction; east if it stays.
sylph::Point directionOf(std::uint8_t action) {
  const auto known = sylph_ros::actionFromMessage(action);
  const sylph::Cell next = sylph::neighbor({0, 0}, known.value_or(sylph::Action::East));
  const sylph::Point direction{static_cast<double>(next.col), static_cast<double>(-next.row)};
  return next == sylph::Cell{0, 0} ? sylph::Point{1.0, 0.0} : direction;
}

Marker badgeSign(const MarkerId& id, RobotStatus status, std::uint8_t action) {
  constexpr double kTop = height::kBadge + 0.01;
  const double r = 0.7 * kBadgeRadiusM;
  constexpr double kLine = 0.02;
  switch (status) {
    case RobotStatus::Enqueued: {
      const sylph::Point way = directionOf(action);
      return triangles(id, arrowHead({0.0, 0.0}, {way.x * r, way.y * r}, 1.8 * r), kTop,
                       bluishGreen());
    }
    case RobotStatus::Staged:  // an hourglass
      return triangles(id, {{-r, r}, {r, r}, {0, 0}, {-r, -r}, {r, -r}, {0, 0}}, kTop, orange());
    case RobotStatus::Done:  // a tick
      return lineStrip(id, {{-r, 0.0}, {-0.3 * r, -0.7 * r}, {r, 0.8 * r}}, kTop, kLine, skyBlue());
    case RobotStatus::Held:  // two bars
      return lineList(id, {{-0.45 * r, -r}, {-0.45 * r, r}, {0.45 * r, -r}, {0.45 * r, r}}, kTop,
                      kLine, yellow());
    case RobotStatus::Fault:  // a cross
      return lineList(id, {{-r, -r}, {r, r}, {-r, r}, {r, -r}}, kTop, kLine, vermillion());
    case RobotStatus::Unknown:
      break;
  }
  return disc(id, {0.0, 0.0}, 0.3 * r, kTop, grey());
}

/// What hangs on one robot at the end of chains of waits.
struct RootCause {
  int held_up = 0;
  double longest_s = 0.0;
  std::string reason;
};

std::map<std::string, RootCause> rootCauses(const Scene& scene) {
  std::map<std::string, RootCause> causes;
  for (const RobotView& robot : scene.robots) {
    if (robot.execution && robot.execution->waiting != 0 &&
        !robot.execution->root_cause_robot.empty()) {
      RootCause& entry = causes[robot.execution->root_cause_robot];
      ++entry.held_up;
      entry.longest_s = std::max(entry.longest_s, robot.execution->waited_s);
      entry.reason = robot.execution->root_cause;
    }
  }
  return causes;
}

/// "holds up 2: has sent no report for 3 s". That a robot drives is seen without words.
void addRootCause(const Scene& scene, const RobotView& robot, int id, const RootCause& cause,
                  Markers& markers) {
  constexpr std::size_t kColumns = 26;
  markers.push_back(
      attach(ring({"root_cause", id}, {0.0, 0.0}, 0.19, height::kWait, 0.03, vermillion()), robot));
  if (cause.longest_s < kLongWaitS) {
    return;
  }
  std::string words = "holds up " + std::to_string(cause.held_up);
  const bool drives = robot.execution && scene.state &&
                      statusOf(*scene.state, *robot.execution) == RobotStatus::Enqueued;
  if (!drives && !cause.reason.empty()) {
    words += ": " + cause.reason;
  }
  int line = 0;
  for (const std::string& part : wrapped(words, kColumns)) {
    markers.push_back(attach(text({"root_cause_text", 10 * id + line}, {0.0, -0.30 - 0.12 * line},
                                  height::kText, 0.10, part, white()),
                             robot));
    ++line;
  }
}

void addWait(const Scene& scene, const RobotView& robot, int id, Markers& markers) {
  const RobotView* other = findRobot(scene, robot.execution->waits_for_robot);
  if (other == nullptr || !other->pose || other == &robot) {
    return;
  }
  const sylph::Point from = sylph::position(*robot.pose);
  const sylph::Point to = sylph::position(*other->pose);
  markers.push_back(
      lineList({"line", id}, dashes(from, to, 0.12, 0.04), height::kWait, 0.03, orange()));
  const double length_m = std::max(sylph::distance(from, to), 1e-6);
  const double part = 1.0 - std::min(0.12 / length_m, 1.0 / 3.0);
  const sylph::Point tip{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
  markers.push_back(triangles({"head", id}, arrowHead(from, tip, 0.10), height::kWait, orange()));
  const sylph_msgs::Cell& cell = robot.execution->waits_for_cell;
  if (const auto center = centerOf(scene, {cell.row, cell.col})) {
    const double r = 0.46 * scene.map->cell_size_m;
    markers.push_back(lineStrip({"cell", id},
                                shifted({{-r, -r}, {r, -r}, {r, r}, {-r, r}, {-r, -r}}, *center),
                                height::kGoal, 0.015, orange()));
  }
  if (robot.execution->waited_s >= kLongWaitS) {
    const std::string seconds = std::to_string(std::lround(robot.execution->waited_s)) + " s";
    markers.push_back(
        attach(text({"time", id}, {0.0, -0.19}, height::kText, 0.10, seconds, orange()), robot));
  }
}

}  // namespace

Markers statusBadge(const std::string& ns, int first_id, RobotStatus status, std::uint8_t action) {
  return {disc({ns, first_id}, {0.0, 0.0}, kBadgeRadiusM + 0.008, height::kBadge, white()),
          disc({ns, first_id + 1}, {0.0, 0.0}, kBadgeRadiusM, height::kBadge + 0.005, black()),
          badgeSign({ns, first_id + 2}, status, action)};
}

Markers statusMarkers(const Scene& scene) {
  Markers markers;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotView& robot = scene.robots[i];
    if (!robot.pose || !robot.execution || !scene.state) {
      continue;
    }
    const int id = static_cast<int>(i);
    const RobotStatus status = statusOf(*scene.state, *robot.execution);
    for (Marker& part : statusBadge("badge", kBadgeMarkers * id, status, robot.execution->action)) {
      part.pose.position.x += kBadgeOffset.x;
      part.pose.position.y += kBadgeOffset.y;
      markers.push_back(attach(std::move(part), robot));
    }
    if (status == RobotStatus::Fault) {
      markers.push_back(attach(text({"fault", id}, {0.0, -0.20}, height::kText, 0.12,
                                    conditionName(*robot.execution), vermillion()),
                               robot));
    }
  }
  return markers;
}

Markers waitMarkers(const Scene& scene) {
  Markers markers;
  const std::map<std::string, RootCause> causes = rootCauses(scene);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotView& robot = scene.robots[i];
    if (!robot.pose) {
      continue;
    }
    const int id = static_cast<int>(i);
    if (robot.execution && robot.execution->waiting != 0) {
      addWait(scene, robot, id, markers);
    }
    const auto cause = causes.find(robot.name);
    if (cause != causes.end()) {
      addRootCause(scene, robot, id, cause->second, markers);
    }
  }
  return markers;
}

}  // namespace sylph_rviz
