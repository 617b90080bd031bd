#include "sylph_core/geometry/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/geometry/segment.hpp"

namespace sylph {
namespace {

using Corners = std::array<Point, 4>;

/// Whether all of `b` lies beyond one edge of `a`.
bool isSeparatedByAnAxisOf(double yaw_rad, const Corners& a, const Corners& b) {
  const std::array<Vector2, 2> axes = {rotate({1.0, 0.0}, yaw_rad), rotate({0.0, 1.0}, yaw_rad)};
  return std::any_of(axes.begin(), axes.end(), [&](const Vector2& axis) {
    const auto along = [&](const Point& p) { return dot({p.x, p.y}, axis); };
    const auto less = [&](const Point& p, const Point& q) { return along(p) < along(q); };
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), less);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), less);
    return along(*a_high) < along(*b_low) || along(*b_high) < along(*a_low);
  });
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
  const Pose2d map_from_robot = {footprint.center.x, footprint.center.y, footprint.yaw_rad};
  const auto at = [&](double forward, double left) {
    return transform(map_from_robot,
                     {forward * footprint.length_m / 2.0, left * footprint.width_m / 2.0});
  };
  return {at(1.0, 1.0), at(-1.0, 1.0), at(-1.0, -1.0), at(1.0, -1.0)};
}

double footprintGap(const Footprint& a, const Footprint& b) {
  const Corners corners_a = corners(a);
  const Corners corners_b = corners(b);
  // Separating axis theorem: convex shapes overlap unless an edge of one of them parts them. Apart,
  // the least distance is between a corner and an edge.
  if (!isSeparatedByAnAxisOf(a.yaw_rad, corners_a, corners_b) &&
      !isSeparatedByAnAxisOf(b.yaw_rad, corners_b, corners_a)) {
    return 0.0;
  }
  return std::min(distanceToEdges(corners_a, corners_b), distanceToEdges(corners_b, corners_a));
}

}  // namespace sylph
