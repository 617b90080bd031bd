#include <algorithm>
#include <cmath>

#include "sylph_rviz/layers.hpp"
#include "sylph_rviz/palette.hpp"

namespace sylph_rviz {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kLargestSvoDeg = 45.0;
constexpr double kGaugeRadiusM = 0.24;

sylph::Point onCircle(double radius_m, double angle_deg) {
  return {radius_m * std::cos(angle_deg * kRadiansPerDegree),
          radius_m * std::sin(angle_deg * kRadiansPerDegree)};
}

/// "25", or "-" for no SVO. RViz's font has no degree sign; the legend names the unit.
std::string svoText(double svo_deg) {
  return std::isfinite(svo_deg) ? std::to_string(std::lround(svo_deg)) : "-";
}

}  // namespace

Markers partnerMarkers(const Scene& scene) {
  Markers markers;
  const std::vector<bool> in_front = inFront(scene);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotView& robot = scene.robots[i];
    if (!robot.pose || !robot.execution || robot.execution->partner.empty()) {
      continue;
    }
    const RobotView* partner = findRobot(scene, robot.execution->partner);
    if (partner == nullptr || !partner->pose || partner == &robot) {
      continue;
    }
    const int id = static_cast<int>(i);
    const float svo_deg = robot.execution->svo_deg;
    const auto color = withAlpha(std::isfinite(svo_deg) ? svoColor(svo_deg) : grey(),
                                 in_front[i] ? 1.0 : kBehindAlpha);
    const auto line = bentLine(sylph::position(*robot.pose), sylph::position(*partner->pose), 0.12);
    markers.push_back(lineStrip({"line", id}, line, height::kPartner, 0.025, color));
    markers.push_back(triangles({"head", id}, arrowHead(line[line.size() - 2], line.back(), 0.10),
                                height::kPartner, color));
  }
  return markers;
}

Markers svoGauge(const std::string& ns, int first_id, double svo_deg, double radius_m) {
  constexpr double kStepDeg = 5.0;
  std::vector<sylph::Point> outline = {{0.0, 0.0}};
  for (double angle_deg = 0.0; angle_deg <= kLargestSvoDeg; angle_deg += kStepDeg) {
    outline.push_back(onCircle(radius_m, angle_deg));
  }
  outline.push_back({0.0, 0.0});
  Markers markers = {lineStrip({ns, first_id}, outline, height::kGauge, 0.01, grey())};
  if (!std::isfinite(svo_deg)) {
    return markers;
  }
  const double filled_deg = std::clamp(svo_deg, 0.0, kLargestSvoDeg);
  std::vector<sylph::Point> corners;
  for (double from_deg = 0.0; from_deg < filled_deg; from_deg += kStepDeg) {
    corners.push_back({0.0, 0.0});
    corners.push_back(onCircle(radius_m, from_deg));
    corners.push_back(onCircle(radius_m, std::min(from_deg + kStepDeg, filled_deg)));
  }
  if (!corners.empty()) {
    markers.push_back(
        triangles({ns, first_id + 1}, corners, height::kGauge + 0.002, svoColor(svo_deg)));
  }
  markers.push_back(lineStrip({ns, first_id + 2}, {{0.0, 0.0}, onCircle(radius_m, filled_deg)},
                              height::kGauge + 0.004, 0.02, white()));
  return markers;
}

Markers svoMarkers(const Scene& scene) {
  Markers markers;
  const std::vector<bool> in_front = inFront(scene);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const RobotView& robot = scene.robots[i];
    if (!robot.pose || !robot.execution) {
      continue;
    }
    const int id = static_cast<int>(i);
    const double svo_deg = robot.execution->svo_deg;
    for (Marker& part : svoGauge("gauge", kGaugeMarkers * id, svo_deg, kGaugeRadiusM)) {
      markers.push_back(attach(std::move(part), robot));
    }
    if (!in_front[i]) {
      continue;  // the gauge says it without a number
    }
    const double letter_m = std::isfinite(svo_deg) ? 0.12 : 0.20;  // a dash is small
    markers.push_back(attach(
        text({"value", id}, {0.05, 0.165}, height::kText, letter_m, svoText(svo_deg), white()),
        robot));
  }
  return markers;
}

}  // namespace sylph_rviz
