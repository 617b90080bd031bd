#pragma once

#include <array>

#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// The rectangle that a robot covers on the floor.
struct Footprint {
  Point center;           ///< in the map frame [m]
  double yaw_rad = 0.0;   ///< of the robot's x axis against the map's x axis [rad]
  double length_m = 0.0;  ///< along the robot's x axis [m], >= 0
  double width_m = 0.0;   ///< along the robot's y axis [m], >= 0
};

/// Corners in the map frame [m], counterclockwise, front left first.
std::array<Point, 4> corners(const Footprint& footprint);

/// The smallest distance between two footprints [m]; 0 if they touch or overlap.
///
/// Two rectangles are apart if and only if one of their four edge normals separates them. The
/// distance of two convex polygons that are apart is that of a corner of one and an edge of the
/// other.
double footprintGap(const Footprint& a, const Footprint& b);

}  // namespace sylph
