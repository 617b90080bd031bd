#include "sylph_core/control/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sylph {
namespace {

using Corners = std::array<Point, 4>;

Point minus(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}

/// Whether all of `b` lies beyond one edge of `a`.
bool isSeparatedByAnAxisOf(double yaw_rad, const Corners& a, const Corners& b) {
  const std::array<Point, 2> axes = {Point{std::cos(yaw_rad), std::sin(yaw_rad)},
                                     Point{-std::sin(yaw_rad), std::cos(yaw_rad)}};
  return std::any_of(axes.begin(), axes.end(), [&](const Point& axis) {
    const auto along = [&](const Point& p, const Point& q) { return dot(p, axis) < dot(q, axis); };
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), along);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), along);
    return dot(*a_high, axis) < dot(*b_low, axis) || dot(*b_high, axis) < dot(*a_low, axis);
  });
}

double distanceToSegment(const Point& point, const Point& from, const Point& to) {
  const Point segment = minus(to, from);
  const Point offset = minus(point, from);
  const double length_squared = dot(segment, segment);
  const double fraction =
      length_squared > 0.0 ? std::clamp(dot(offset, segment) / length_squared, 0.0, 1.0) : 0.0;
  return std::hypot(offset.x - fraction * segment.x, offset.y - fraction * segment.y);
}

/// Smallest distance of a corner of `points` and an edge of `polygon`.
double distanceToEdges(const Corners& points, const Corners& polygon) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Point& point : points) {
    for (std::size_t edge = 0; edge < polygon.size(); ++edge) {
      smallest = std::min(
          smallest, distanceToSegment(point, polygon[edge], polygon[(edge + 1) % polygon.size()]));
    }
  }
  return smallest;
}

}  // namespace

std::array<Point, 4> corners(const Footprint& footprint) {
  const double cos_yaw = std::cos(footprint.yaw_rad);
  const double sin_yaw = std::sin(footprint.yaw_rad);
  const auto at = [&](double forward, double left) {
    const double x = forward * footprint.length_m / 2.0;
    const double y = left * footprint.width_m / 2.0;
    return Point{footprint.center.x + x * cos_yaw - y * sin_yaw,
                 footprint.center.y + x * sin_yaw + y * cos_yaw};
  };
  return {at(1.0, 1.0), at(-1.0, 1.0), at(-1.0, -1.0), at(1.0, -1.0)};
}

double footprintGap(const Footprint& a, const Footprint& b) {
  const Corners corners_a = corners(a);
  const Corners corners_b = corners(b);
  if (!isSeparatedByAnAxisOf(a.yaw_rad, corners_a, corners_b) &&
      !isSeparatedByAnAxisOf(b.yaw_rad, corners_b, corners_a)) {
    return 0.0;
  }
  return std::min(distanceToEdges(corners_a, corners_b), distanceToEdges(corners_b, corners_a));
}

}  // namespace sylph
