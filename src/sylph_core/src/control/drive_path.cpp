#include "sylph_core/control/drive_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sylph {
namespace {

constexpr double kSmallestBlend_m = 0.001;
// Of the shorter leg, so that the blends at its two ends never meet.
constexpr double kLargestShareOfLeg = 0.45;
constexpr double kStraightCosine = 0.999;   // turns below 2.6 degrees
constexpr double kSharpestCosine = -0.707;  // no blend for turns above 135 degrees

}  // namespace

double distanceToLeg(const Leg& leg, const Point& point) {
  const Vector2 offset = displacement(leg.start, point);
  const double along = std::clamp(dot(offset, leg.direction), 0.0, leg.length_m);
  const Vector2 across = offset - along * leg.direction;
  return norm(across);
}

double halfTurnSine(const Vector2& in, const Vector2& out) {
  const Vector2 change = out - in;
  return norm(change) / 2.0;
}

void DrivePath::append(const Point& end, double blend_m) {
  const Vector2 way = displacement(waypoints_.back(), end);
  const double length_m = norm(way);
  if (!std::isfinite(length_m) || length_m <= 0.0) {
    throw std::invalid_argument("leg of a path from a point to itself or to nowhere");
  }
  const Leg leg{waypoints_.back(), end, (1.0 / length_m) * way, length_m};
  if (!legs_.empty()) {
    const double cosine = dot(legs_.back().direction, leg.direction);
    const double blend =
        std::min(blend_m, kLargestShareOfLeg * std::min(legs_.back().length_m, length_m));
    const bool is_straight = cosine > kStraightCosine;
    const bool is_blend = !is_straight && cosine > kSharpestCosine && blend >= kSmallestBlend_m;
    corners_.push_back(is_straight ? Corner::Straight : is_blend ? Corner::Blend : Corner::Stop);
    blends_m_.push_back(is_blend ? blend : 0.0);
  }
  legs_.push_back(leg);
  waypoints_.push_back(end);
}

Corner DrivePath::corner(int waypoint) const {
  if (waypoint <= 0 || waypoint >= legCount()) {
    return Corner::Stop;
  }
  return corners_[static_cast<std::size_t>(waypoint - 1)];
}

double DrivePath::blend(int waypoint) const {
  if (waypoint <= 0 || waypoint >= legCount()) {
    return 0.0;
  }
  return blends_m_[static_cast<std::size_t>(waypoint - 1)];
}

double DrivePath::blendSpeed(int waypoint, double acceleration_mps2) const {
  if (corner(waypoint) != Corner::Blend) {
    return 0.0;
  }
  const double sine = halfTurnSine(leg(waypoint - 1).direction, leg(waypoint).direction);
  return std::sqrt(acceleration_mps2 * blend(waypoint) / sine);
}

}  // namespace sylph
