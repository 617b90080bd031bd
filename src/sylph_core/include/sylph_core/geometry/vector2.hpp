#pragma once

#include <cmath>

namespace sylph {

/// A position in a frame [m].
struct Point {
  double x = 0.0;  ///< to the right in `map`, forward in a robot's frame
  double y = 0.0;  ///< up in `map`, left in a robot's frame
};

/// A direction, displacement or velocity in the plane.
struct Vector2 {
  /// Along the axes of whatever frame the variable's name tells [m, m/s, ...].
  double x = 0.0;
  double y = 0.0;
};

inline Vector2 operator+(const Vector2& a, const Vector2& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vector2 operator-(const Vector2& a, const Vector2& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vector2 operator*(double factor, const Vector2& v) {
  return {factor * v.x, factor * v.y};
}
/// Inner product.
inline double dot(const Vector2& a, const Vector2& b) {
  return a.x * b.x + a.y * b.y;
}
/// What leads from one point to another.
inline Vector2 displacement(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y};
}
inline Point operator+(const Point& point, const Vector2& displacement) {
  return {point.x + displacement.x, point.y + displacement.y};
}
/// Euclidean length. Lengths here are far from overflow, against which std::hypot guards at four
/// times the price: it took a fifth of a rehearsal with 64 robots.
inline double norm(const Vector2& v) {
  return std::sqrt(dot(v, v));
}
/// Half the sides, along the axes, of the box round a rectangle that is turned by `yaw_rad`.
inline Vector2 halfBox(double length, double width, double yaw_rad) {
  const double c = std::abs(std::cos(yaw_rad));
  const double s = std::abs(std::sin(yaw_rad));
  return {(length * c + width * s) / 2.0, (length * s + width * c) / 2.0};
}
/// Turned counterclockwise.
inline Vector2 rotate(const Vector2& v, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace sylph
