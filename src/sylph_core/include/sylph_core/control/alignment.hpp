#pragma once

#include <optional>
#include <string>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// The way of one robot to the middle of its cell, before its plan begins: it turns to its heading
/// first, then drives straight and slowly, so that it is known beforehand what it covers.
///
/// A robot whose pose does not come nearer as it is driven has a dead base or another robot's body:
/// it holds after 20 mm or 15 deg in vain, less than the clearance with which it was let go.
class Alignment {
 public:
  /// @param target  middle of the cell, in the map [m]
  /// @param from  where the robot stands
  /// @param heading_rad  to turn to
  /// @param heading_tolerance_rad  within which it drives, > 0
  Alignment(const Point& target, const Pose2d& from, double heading_rad,
            double heading_tolerance_rad);

  const Point& target() const { return target_; }
  /// What of a velocity along the axes of the map may be commanded.
  /// @param pose  measured last
  /// @param duration_s  for which it is commanded, >= 0
  Twist2d limit(const Twist2d& wanted_map, const Pose2d& pose, double duration_s);
  /// Why the robot must not go on, for the operator; stays.
  const std::optional<std::string>& problem() const { return problem_; }

 private:
  double distanceFrom(const Pose2d& pose) const { return distance(position(pose), target_); }
  double angleFrom(const Pose2d& pose) const;

  Point target_;
  double heading_rad_;
  double heading_tolerance_rad_;
  double to_go_m_;  // at the start
  double to_go_rad_;
  double commanded_m_ = 0.0;
  double commanded_rad_ = 0.0;
  std::optional<std::string> problem_;
};

}  // namespace sylph
