#pragma once

#include "sylph_core/control/drive_path.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// Tolerances of hasArrived().
struct ArrivalOptions {
  double position_tolerance_m = 0.010;    ///< from the end of the leg, > 0
  double heading_tolerance_rad = 0.0524;  ///< > 0
  double tracking_error_m = 0.012;        ///< from the legs that the robot still holds, > 0
  double acceleration_limit_mps2 = 0.6;   ///< with which it could stop, > 0
};

/// Whether a robot has done a leg of its path, so that others may enter the cell that it leaves.
///
/// That cell is clear once the robot is at the end of the leg and stays within the tracking error
/// of what it holds from then on: the rest of its path, or the end of the leg if there is no more.
/// So:
///
/// - the measured position is within the tolerance of the end of the leg, or has passed it along a
///   next leg that does not lead back, within the tracking error of that leg;
/// - where the robot would come to rest if it braked now is within the tracking error of the rest;
/// - the heading is within tolerance: the footprint counts on it.
///
/// @param path      all legs that are held
/// @param leg       the one in question
/// @param measured  pose
/// @param velocity_map  [m/s]
/// @param heading_rad   that the robot has to hold
bool hasArrived(const DrivePath& path, int leg, const Pose2d& measured, const Vector2& velocity_map,
                double heading_rad, const ArrivalOptions& options);

/// Whether a robot without a path is at a point: the measured position and heading are within their
/// tolerances, and so is where it would come to rest if it braked now.
/// @param velocity_map  [m/s]
/// @param heading_rad   that the robot has to hold
bool isAtRestIn(const Point& point, const Pose2d& measured, const Vector2& velocity_map,
                double heading_rad, const ArrivalOptions& options);

/// Distance from a point to the closest of the legs `first` ... last of a path; to the last
/// waypoint if there is none [m].
double distanceToRest(const DrivePath& path, int first, const Point& point);

}  // namespace sylph
