#include "sylph_core/geometry/footprint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Points that cover the rectangle, its border included.
std::vector<Point> samplesOf(const Footprint& footprint, int per_side) {
  std::vector<Point> samples;
  for (int i = 0; i <= per_side; ++i) {
    for (int j = 0; j <= per_side; ++j) {
      const double x = (static_cast<double>(i) / per_side - 0.5) * footprint.length_m;
      const double y = (static_cast<double>(j) / per_side - 0.5) * footprint.width_m;
      samples.push_back(
          {footprint.center.x + x * std::cos(footprint.yaw_rad) - y * std::sin(footprint.yaw_rad),
           footprint.center.y + x * std::sin(footprint.yaw_rad) + y * std::cos(footprint.yaw_rad)});
    }
  }
  return samples;
}

/// Distance from a point to the rectangle, computed in the rectangle's own frame.
double distanceToRectangle(const Point& point, const Footprint& footprint) {
  const double dx = point.x - footprint.center.x;
  const double dy = point.y - footprint.center.y;
  const double forward = dx * std::cos(footprint.yaw_rad) + dy * std::sin(footprint.yaw_rad);
  const double left = -dx * std::sin(footprint.yaw_rad) + dy * std::cos(footprint.yaw_rad);
  return std::hypot(std::max(std::abs(forward) - footprint.length_m / 2.0, 0.0),
                    std::max(std::abs(left) - footprint.width_m / 2.0, 0.0));
}

double bruteForceGap(const Footprint& a, const Footprint& b, int per_side) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Point& point : samplesOf(a, per_side)) {
    smallest = std::min(smallest, distanceToRectangle(point, b));
  }
  for (const Point& point : samplesOf(b, per_side)) {
    smallest = std::min(smallest, distanceToRectangle(point, a));
  }
  return smallest;
}

TEST(FootprintGapTest, IsTheDistanceOfFacingSides) {
  const Footprint a{{0.0, 0.0}, 0.0, 0.23, 0.20};
  EXPECT_NEAR(0.07, footprintGap(a, {{0.3, 0.0}, 0.0, 0.23, 0.20}), 1e-12);
  EXPECT_NEAR(0.10, footprintGap(a, {{0.0, 0.3}, 0.0, 0.23, 0.20}), 1e-12);
  EXPECT_NEAR(0.10, footprintGap(a, {{0.0, 0.3}, kPi, 0.23, 0.20}), 1e-12);
}

TEST(FootprintGapTest, IsTheDistanceOfCornersOnADiagonal) {
  const Footprint a{{0.0, 0.0}, 0.0, 0.2, 0.2};
  EXPECT_NEAR(std::hypot(0.1, 0.1), footprintGap(a, {{0.3, 0.3}, 0.0, 0.2, 0.2}), 1e-12);
}

TEST(FootprintGapTest, IsZeroForOverlapContainmentAndACross) {
  const Footprint large{{0.0, 0.0}, 0.4, 1.0, 1.0};
  EXPECT_EQ(0.0, footprintGap(large, {{0.1, 0.1}, 1.0, 0.1, 0.1}));
  EXPECT_EQ(0.0, footprintGap({{0.1, 0.1}, 1.0, 0.1, 0.1}, large));
  // A cross: no corner of one lies in the other.
  EXPECT_EQ(0.0, footprintGap({{0.0, 0.0}, 0.0, 1.0, 0.1}, {{0.0, 0.0}, kPi / 2, 1.0, 0.1}));
}

TEST(FootprintGapTest, RobotsWithFreeHeadingsCanTouchAtExactCentres) {
  // 0.23 x 0.20 m has a longer diagonal than a cell of 0.30 m.
  EXPECT_EQ(0.0, footprintGap({{0.0, 0.0}, 0.72, 0.23, 0.20}, {{0.3, 0.0}, -0.72, 0.23, 0.20}));
}

TEST(FootprintGapProperty, EqualsBruteForceAndIsSymmetric) {
  Rng rng(7);
  const auto draw = [&] {
    const Point center{drawBetween(rng, -0.4, 0.4), drawBetween(rng, -0.4, 0.4)};
    return Footprint{center, drawBetween(rng, -kPi, kPi), drawBetween(rng, 0.05, 0.4),
                     drawBetween(rng, 0.05, 0.4)};
  };
  const int per_side = 40;
  int overlapping = 0;
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Footprint a = draw();
    const Footprint b = draw();
    const double gap = footprintGap(a, b);
    // Samples contain every corner, so the brute force is exact for rectangles that are apart and
    // misses an overlap by less than the distance of two samples.
    const double expected = bruteForceGap(a, b, per_side);
    if (gap > 0.0) {
      EXPECT_NEAR(expected, gap, 1e-9);
    } else {
      EXPECT_LT(expected, 0.4 * std::sqrt(2.0) / per_side);
      ++overlapping;
    }
    EXPECT_NEAR(gap, footprintGap(b, a), 1e-12);
  }
  EXPECT_GT(overlapping, 50);
  EXPECT_LT(overlapping, 450);
}

}  // namespace
}  // namespace sylph
