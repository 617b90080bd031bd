#pragma once

#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// Where a frame is in another one: an element of SE(2). Yaw is counterclockwise from the x axis of
/// the other frame to that of the frame. Names compose: `map_from_robot` is where a robot is in the
/// `map` frame, and takes what is told in the robot's frame to the map.
struct Pose2d {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// Velocity of a robot; the name of the variable tells the frame: `twist_robot` has x forward and
/// y left (REP 103), `twist_map` the axes of the map.
struct Twist2d {
  double x_mps = 0.0;
  double y_mps = 0.0;
  double turn_radps = 0.0;
};

/// The origin of the frame, in the other one.
inline Point position(const Pose2d& pose) {
  return {pose.x_m, pose.y_m};
}

/// a_from_c, with a yaw in (-pi, pi].
Pose2d compose(const Pose2d& a_from_b, const Pose2d& b_from_c);

/// b_from_a, with a yaw in (-pi, pi].
Pose2d inverse(const Pose2d& a_from_b);

/// The coordinates in frame a of a point given in frame b.
Point transform(const Pose2d& a_from_b, const Point& point_b);

/// Euclidean length of the translational part [m/s].
double speed(const Twist2d& twist);

/// Distance between two points [m].
double distance(const Point& a, const Point& b);

/// Whether all three numbers are.
bool isFinite(const Pose2d& pose);

/// The equal angle in (-pi, pi] [rad].
double normalizeAngle(double angle_rad);

/// The smallest rotation that turns `from_rad` into `to_rad`, in (-pi, pi] [rad].
double shortestAngle(double from_rad, double to_rad);

/// The same velocity along the axes of a robot that stands at `yaw_rad`: a rotation by -yaw.
Twist2d robotFromMap(const Twist2d& twist_map, double yaw_rad);
/// The same velocity along the axes of the map: a rotation by yaw.
Twist2d mapFromRobot(const Twist2d& twist_robot, double yaw_rad);

}  // namespace sylph
