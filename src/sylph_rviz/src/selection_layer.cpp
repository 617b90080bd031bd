#include <algorithm>

#include "sylph_ros/conversions.hpp"
#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

constexpr double kSelectionRadiusM = 0.20;
constexpr double kPartnerRadiusM = 0.18;

std::vector<sylph::Point> centersOf(const Scene& scene, const std::vector<sylph::Cell>& cells) {
  std::vector<sylph::Point> centers;
  for (const sylph::Cell& cell : cells) {
    if (const auto center = centerOf(scene, cell)) {
      centers.push_back(*center);
    }
  }
  return centers;
}

void addHeldCells(const Scene& scene, const RobotView& robot, const std_msgs::ColorRGBA& color,
                  Markers& markers) {
  int id = 0;
  for (const sylph_msgs::Cell& cell : robot.execution->held_cells) {
    if (const auto center = centerOf(scene, sylph_ros::fromMessage(cell))) {
      const double side_m = 0.96 * scene.map->cell_size_m;
      markers.push_back(
          box({"held", id++}, *center, side_m, side_m, height::kHeldCell, withAlpha(color, 0.3)));
    }
  }
}

void addPaths(const Scene& scene, const RobotView& robot, const std_msgs::ColorRGBA& color,
              Markers& markers) {
  const std::vector<sylph::Point> planned = pieces(centersOf(scene, plannedPath(scene, robot)));
  if (!planned.empty()) {
    markers.push_back(
        lineList({"planned", 0}, planned, height::kPlanned, 0.07, withAlpha(color, 0.5)));
  }
  const std::vector<sylph::Point> driven = pieces(robot.driven);
  if (!driven.empty()) {
    markers.push_back(lineList({"driven", 0}, driven, height::kDriven, 0.02, white()));
  }
}

void addPartner(const Scene& scene, const RobotView& robot, Markers& markers) {
  const RobotView* partner = findRobot(scene, robot.execution->partner);
  if (partner == nullptr || !partner->pose || !partner->execution) {
    return;
  }
  const auto color = robotColor(static_cast<std::size_t>(partner - scene.robots.data()));
  markers.push_back(attach(
      ring({"partner", 0}, {0.0, 0.0}, kPartnerRadiusM, height::kWait, 0.015, color), *partner));
  std::vector<sylph::Cell> cells;
  for (const sylph_msgs::Cell& cell : partner->execution->remaining_path) {
    cells.push_back(sylph_ros::fromMessage(cell));
  }
  const std::vector<sylph::Point> way = dashesAlong(pieces(centersOf(scene, cells)), 0.05);
  if (!way.empty()) {
    markers.push_back(lineList({"partner_way", 0}, way, height::kDriven, 0.04, color));
  }
}

/// A numbered arrow from each robot of the chain to the one for which it waits.
void addChain(const std::vector<const RobotView*>& chain, Markers& markers) {
  constexpr double kGapM = 0.13;
  for (std::size_t k = 1; k < chain.size(); ++k) {
    if (!chain[k - 1]->pose || !chain[k]->pose) {
      return;
    }
    const int id = static_cast<int>(k);
    const sylph::Point from = sylph::position(*chain[k - 1]->pose);
    const sylph::Point to = sylph::position(*chain[k]->pose);
    const double length_m = sylph::distance(from, to);
    const sylph::Vector2 step = (1.0 / std::max(length_m, 1e-6)) * sylph::displacement(from, to);
    const sylph::Point begin = from + kGapM * step;
    const sylph::Point tip = from + std::max(length_m - kGapM, kGapM) * step;
    markers.push_back(
        lineList({"chain", id}, {begin, tip + (-0.06 * step)}, height::kPartner, 0.05, orange()));
    markers.push_back(triangles({"chain_head", id}, arrowHead(from, tip, 0.14),
                                height::kPartner + 0.005, orange()));
    const sylph::Point middle = from + (0.5 * length_m) * step;
    markers.push_back(disc({"chain_disc", id}, middle, 0.06, height::kBadge, orange()));
    markers.push_back(text({"chain_number", id}, middle, height::kText, 0.10, std::to_string(k),
                           textColorOn(orange())));
  }
}

}  // namespace

Markers selectionMarkers(const Scene& scene) {
  Markers markers;
  const RobotView* robot = findRobot(scene, scene.selected);
  if (robot == nullptr) {
    return markers;
  }
  const auto color = robotColor(static_cast<std::size_t>(robot - scene.robots.data()));
  if (robot->pose) {
    markers.push_back(
        attach(ring({"selected", 0}, {0.0, 0.0}, kSelectionRadiusM, height::kWait, 0.03, white()),
               *robot));
  }
  if (robot->execution) {
    addHeldCells(scene, *robot, color, markers);
    addPartner(scene, *robot, markers);
  }
  addPaths(scene, *robot, color, markers);
  addChain(waitChain(scene, scene.selected), markers);
  return markers;
}

}  // namespace sylph_rviz
