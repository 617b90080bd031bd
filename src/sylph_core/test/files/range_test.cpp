#include "sylph_core/files/range.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sylph {
namespace {

TEST(RangeTest, HoldsItsEndsUnlessItIsOpenBelow) {
  const Range share{0.0, 1.0};
  EXPECT_TRUE(share.contains(0.0));
  EXPECT_TRUE(share.contains(1.0));
  EXPECT_FALSE(share.contains(-0.001));
  EXPECT_FALSE(share.contains(1.001));
  EXPECT_FALSE(Range::positive().contains(0.0));
  EXPECT_TRUE(Range::positive().contains(1e-9));
}

TEST(RangeTest, HoldsNothingThatIsNotFinite) {
  EXPECT_FALSE(Range{}.contains(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(Range{}.contains(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Range{}.contains(-std::numeric_limits<double>::infinity()));
}

TEST(RangeTest, SaysWhatItHolds) {
  EXPECT_EQ("> 0", toString(Range::positive()));
  EXPECT_EQ(">= 1.5", toString(Range::atLeast(1.5)));
  EXPECT_EQ("0 ... 1", toString(Range{0.0, 1.0}));
  EXPECT_EQ("> 0 and <= 5", toString(Range{0.0, 5.0, true}));
  EXPECT_EQ("finite", toString(Range{}));
}

TEST(RangeTest, WritesNumbersAsAPersonWould) {
  EXPECT_EQ("0.05", shortNumber(0.05));
  EXPECT_EQ("1000000", shortNumber(1e6));
  EXPECT_EQ("0.0524", shortNumber(0.0524));
}

}  // namespace
}  // namespace sylph
