#pragma once

namespace sylph {

/// A position in a frame [m].
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// A direction, displacement or velocity in the plane.
struct Vector2 {
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
inline double dot(const Vector2& a, const Vector2& b) {
  return a.x * b.x + a.y * b.y;
}
inline Vector2 displacement(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y};
}

}  // namespace sylph
