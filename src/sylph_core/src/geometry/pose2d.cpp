#include "sylph_core/geometry/pose2d.hpp"

#include <cmath>

namespace sylph {
namespace {

Twist2d turned(const Twist2d& twist, double angle_rad) {
  const Vector2 velocity = rotate({twist.x_mps, twist.y_mps}, angle_rad);
  return {velocity.x, velocity.y, twist.turn_radps};
}

}  // namespace

Pose2d compose(const Pose2d& a_from_b, const Pose2d& b_from_c) {
  const Point origin_c = transform(a_from_b, position(b_from_c));
  return {origin_c.x, origin_c.y, normalizeAngle(a_from_b.yaw_rad + b_from_c.yaw_rad)};
}

Pose2d inverse(const Pose2d& a_from_b) {
  const Vector2 back = rotate({-a_from_b.x_m, -a_from_b.y_m}, -a_from_b.yaw_rad);
  return {back.x, back.y, normalizeAngle(-a_from_b.yaw_rad)};
}

Point transform(const Pose2d& a_from_b, const Point& point_b) {
  return position(a_from_b) + rotate({point_b.x, point_b.y}, a_from_b.yaw_rad);
}

double speed(const Twist2d& twist) {
  return norm({twist.x_mps, twist.y_mps});
}

double distance(const Point& a, const Point& b) {
  return norm(displacement(a, b));
}

bool isFinite(const Pose2d& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}

double normalizeAngle(double angle_rad) {
  if (angle_rad > -M_PI && angle_rad <= M_PI) {
    return angle_rad;  // as nearly always
  }
  const double angle = std::remainder(angle_rad, 2.0 * M_PI);  // in [-pi, pi]
  return angle <= -M_PI ? M_PI : angle;
}

double shortestAngle(double from_rad, double to_rad) {
  return normalizeAngle(to_rad - from_rad);
}

Twist2d robotFromMap(const Twist2d& twist_map, double yaw_rad) {
  return turned(twist_map, -yaw_rad);
}

Twist2d mapFromRobot(const Twist2d& twist_robot, double yaw_rad) {
  return turned(twist_robot, yaw_rad);
}

}  // namespace sylph
