#pragma once

#include <algorithm>

#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// Distance from a point to the nearest point of a segment, whose ends may coincide [m].
inline double distanceToSegment(const Point& point, const Point& from, const Point& to) {
  const Vector2 segment = displacement(from, to);
  const Vector2 offset = displacement(from, point);
  const double length_squared = dot(segment, segment);
  const double fraction =
      length_squared > 0.0 ? std::clamp(dot(offset, segment) / length_squared, 0.0, 1.0) : 0.0;
  return norm(offset - fraction * segment);
}

}  // namespace sylph
