#pragma once

#include <vector>

#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// One straight leg of a path.
struct Leg {
  Point start;            ///< [m], map frame
  Point end;              ///< [m], map frame
  Vector2 direction;      ///< of unit length
  double length_m = 0.0;  ///< > 0
};

/// Distance from a point to the closest point of a leg, its ends included [m].
double distanceToLeg(const Leg& leg, const Point& point);

/// How a path goes on where two legs meet.
enum class Corner {
  Straight,  ///< driven through
  Blend,     ///< a parabola that passes the corner at a small distance
  Stop,      ///< the robot comes to rest: a sharp corner, a reversal, or the end of the path
};

/// The centres of the cells that a robot has to pass, and how it rounds each corner.
///
/// At a corner with blend distance D the path leaves the incoming leg (unit vector t1) D before the
/// corner C and joins the outgoing leg (t2) D behind it, on the parabola
///
///     p(s) = C - D (1 - s)^2 t1 + D s^2 t2,   s in [0, 1]
///
/// which is the course of a constant acceleration v (t2 - t1) / T, T = 2 D / v, so a robot with
/// acceleration limit a may drive it at
///
///     v = sqrt(a D / sin(turn / 2))   (90 degrees: sqrt(sqrt(2) a D))
///
/// Its distance from the corner is D/2 sin(turn / 2) at least, from the legs at most half of that
/// times sqrt(2) at 90 degrees (D/4): with D = 20 mm, 7 mm and 5 mm. "Linear segments with
/// parabolic blends": Biagiotti, Melchiorri, "Trajectory Planning for Automatic Machines and
/// Robots", 2008.
class DrivePath {
 public:
  /// A path of one waypoint.
  explicit DrivePath(const Point& start) : waypoints_{start} {}

  /// Adds a leg from the last waypoint to `end`.
  /// @param blend_m  largest blend distance at the last waypoint [m], >= 0; it is cut to 45 % of
  ///                 either leg; below 1 mm the robot stops there
  /// @throws std::invalid_argument if `end` is the last waypoint or not finite
  void append(const Point& end, double blend_m);

  int waypointCount() const { return static_cast<int>(waypoints_.size()); }
  int legCount() const { return static_cast<int>(legs_.size()); }
  const Point& waypoint(int index) const { return waypoints_.at(static_cast<std::size_t>(index)); }
  /// The leg from waypoint `index` to waypoint `index` + 1.
  const Leg& leg(int index) const { return legs_.at(static_cast<std::size_t>(index)); }

  /// How the path passes a waypoint; Stop at both ends.
  Corner corner(int waypoint) const;
  /// Blend distance at a waypoint [m], 0 unless its corner is Blend.
  double blend(int waypoint) const;
  /// Speed at which a blend may be entered and left [m/s].
  double blendSpeed(int waypoint, double acceleration_mps2) const;

 private:
  std::vector<Point> waypoints_;
  std::vector<Leg> legs_;
  std::vector<Corner> corners_;   // of waypoints 1 ... legCount() - 1
  std::vector<double> blends_m_;  // of the same
};

/// sin(turn / 2) of the corner between two unit vectors.
double halfTurnSine(const Vector2& in, const Vector2& out);

}  // namespace sylph
