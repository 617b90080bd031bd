#include "sylph_core/geometry/circle_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CircleGridTest, FindsWhatTouchesAndNotWhatIsFarAway) {
  CircleGrid grid(0.3);
  grid.put(2, {0.0, 0.0}, 0.3);
  grid.put(0, {1.0, 0.0}, 0.3);
  grid.put(1, {50.0, 0.0}, 0.3);
  EXPECT_EQ((std::vector<int>{0, 2}), grid.near({0.0, 0.0}, 0.7)) << "they just touch";
  grid.put(0, {-50.0, 0.0}, 0.3);
  EXPECT_EQ((std::vector<int>{2}), grid.near({0.0, 0.0}, 0.7)) << "it has moved";
  EXPECT_EQ((std::vector<int>{0, 1, 2}), grid.near({0.0, 0.0}, kInfinity));
  grid.put(1, {50.0, 0.0}, kInfinity);
  EXPECT_EQ((std::vector<int>{1, 2}), grid.near({0.0, 0.0}, 0.0));
}

TEST(CircleGridTest, LooksAtFewOfACrowd) {
  CircleGrid grid(0.3);
  constexpr int kSide = 100;
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      grid.put(row * kSide + col, {1.0 * col, 1.0 * row}, 0.3);
    }
  }
  // Another one that reaches far makes it no more.
  grid.put(kSide * kSide, {-1000.0, 0.0}, 40.0);
  EXPECT_LE(grid.near({50.0, 50.0}, 0.3).size(), 16U);
}

/// Mostly small, near and crowded; some are far out and some are large.
double drawScale(Rng& rng) {
  constexpr double kScales[] = {1.0, 1.0, 1.0, 1.0, 30.0, 1e4, 1e200};
  return kScales[drawIndex(rng, std::size(kScales))];
}

TEST(CircleGridProperty, LeavesOutNoCircleThatMeetsAnother) {
  struct Circle {
    Point center;
    double radius_m = 0.0;
    bool is_in = false;
  };
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    CircleGrid grid(0.3);
    std::vector<Circle> circles(40);
    const auto draw = [&rng](double most) {
      return most * drawScale(rng) * drawBetween(rng, -1.0, 1.0);
    };
    for (int turn = 0; turn < 400; ++turn) {
      const std::size_t moved = drawIndex(rng, circles.size());
      circles[moved] = {{draw(3.0), draw(3.0)}, std::abs(draw(0.5)), true};
      grid.put(static_cast<int>(moved), circles[moved].center, circles[moved].radius_m);
      const Circle asked{{draw(3.0), draw(3.0)}, std::abs(draw(0.5)), true};
      const std::vector<int> near = grid.near(asked.center, asked.radius_m);
      ASSERT_TRUE(std::is_sorted(near.begin(), near.end()));
      ASSERT_EQ(near.end(), std::adjacent_find(near.begin(), near.end()));
      for (std::size_t index = 0; index < circles.size(); ++index) {
        const Circle& other = circles[index];
        if (other.is_in &&
            distance(asked.center, other.center) <= asked.radius_m + other.radius_m) {
          ASSERT_TRUE(std::binary_search(near.begin(), near.end(), static_cast<int>(index)))
              << index;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sylph
