#include "sylph_core/control/arrival.hpp"

#include <algorithm>
#include <cmath>

namespace sylph {
namespace {

// Enough for a robot that is about to leave one leg, drives the next and brakes into a third.
constexpr int kLegsAhead = 3;

bool isAtEnd(const DrivePath& path, int leg, const Point& here, const ArrivalOptions& options) {
  if (distance(path.waypoint(leg + 1), here) <= options.position_tolerance_m) {
    return true;
  }
  if (leg + 1 >= path.legCount()) {
    return false;
  }
  const Leg& next = path.leg(leg + 1);
  // Where the way leads straight back, the next leg runs along this one: who is not yet at the end
  // would count as on it.
  const bool leads_back = dot(path.leg(leg).direction, next.direction) < -0.5;
  const Vector2 beyond = displacement(next.start, here);
  // Blends leave a corner aside: the end is reached where the next leg is.
  const bool has_passed = dot(beyond, path.leg(leg).direction) >= -options.position_tolerance_m &&
                          dot(beyond, next.direction) >= 0.0;
  return !leads_back && has_passed && distanceToLeg(next, here) <= options.tracking_error_m;
}

/// Where a robot comes to rest if it brakes now.
Point restOf(const Point& here, const Vector2& velocity_map, const ArrivalOptions& options) {
  const double braking_s = norm(velocity_map) / (2.0 * options.acceleration_limit_mps2);
  return {here.x + braking_s * velocity_map.x, here.y + braking_s * velocity_map.y};
}

bool isTurned(const Pose2d& measured, double heading_rad, const ArrivalOptions& options) {
  return std::abs(shortestAngle(measured.yaw_rad, heading_rad)) > options.heading_tolerance_rad;
}

}  // namespace

double distanceToRest(const DrivePath& path, int first, const Point& point) {
  const int end = std::min(first + kLegsAhead, path.legCount());
  if (first >= end) {
    return distance(path.waypoint(path.legCount()), point);
  }
  double smallest_m = distanceToLeg(path.leg(first), point);
  for (int leg = first + 1; leg < end; ++leg) {
    smallest_m = std::min(smallest_m, distanceToLeg(path.leg(leg), point));
  }
  return smallest_m;
}

bool hasArrived(const DrivePath& path, int leg, const Pose2d& measured, const Vector2& velocity_map,
                double heading_rad, const ArrivalOptions& options) {
  const Point here = position(measured);
  // A robot that comes in too fast to rest near the path has not arrived, or its cell would be
  // given away while it slides on.
  return isAtEnd(path, leg, here, options) && !isTurned(measured, heading_rad, options) &&
         distanceToRest(path, leg + 1, restOf(here, velocity_map, options)) <=
             options.tracking_error_m;
}

bool isAtRestIn(const Point& point, const Pose2d& measured, const Vector2& velocity_map,
                double heading_rad, const ArrivalOptions& options) {
  const Point here = position(measured);
  return !isTurned(measured, heading_rad, options) &&
         distance(point, here) <= options.position_tolerance_m &&
         distance(point, restOf(here, velocity_map, options)) <= options.position_tolerance_m;
}

}  // namespace sylph
