#include "sylph_core/geometry/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sylph {
namespace {

TEST(SegmentTest, TheNearestPointIsBetweenItsEndsOrOneOfThem) {
  const Point from{1.0, 1.0};
  const Point to{5.0, 1.0};
  EXPECT_DOUBLE_EQ(2.0, distanceToSegment({3.0, 3.0}, from, to));
  EXPECT_DOUBLE_EQ(0.0, distanceToSegment({4.0, 1.0}, from, to));
  EXPECT_DOUBLE_EQ(std::sqrt(2.0), distanceToSegment({0.0, 0.0}, from, to));
  EXPECT_DOUBLE_EQ(5.0, distanceToSegment({8.0, 5.0}, from, to));
}

TEST(SegmentTest, OneWithoutLengthIsAPoint) {
  EXPECT_DOUBLE_EQ(5.0, distanceToSegment({4.0, 5.0}, {1.0, 1.0}, {1.0, 1.0}));
}

}  // namespace
}  // namespace sylph
