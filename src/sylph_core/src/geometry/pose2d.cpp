#include "sylph_core/geometry/pose2d.hpp"

#include <cmath>

namespace sylph {
namespace {

Twist2d rotate(const Twist2d& twist, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * twist.x_mps - s * twist.y_mps, s * twist.x_mps + c * twist.y_mps, twist.turn_radps};
}

}  // namespace

double speed(const Twist2d& twist) {
  return std::hypot(twist.x_mps, twist.y_mps);
}

double distance(const Point& a, const Point& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

bool isFinite(const Pose2d& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}

double normalizeAngle(double angle_rad) {
  const double angle = std::remainder(angle_rad, 2.0 * M_PI);  // in [-pi, pi]
  return angle <= -M_PI ? M_PI : angle;
}

double shortestAngle(double from_rad, double to_rad) {
  return normalizeAngle(to_rad - from_rad);
}

Twist2d robotFromMap(const Twist2d& twist_map, double yaw_rad) {
  return rotate(twist_map, -yaw_rad);
}

Twist2d mapFromRobot(const Twist2d& twist_robot, double yaw_rad) {
  return rotate(twist_robot, yaw_rad);
}

}  // namespace sylph
