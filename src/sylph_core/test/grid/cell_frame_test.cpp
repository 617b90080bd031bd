#include "sylph_core/grid/cell_frame.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph {
namespace {

TEST(CellFrameTest, RowZeroIsTheTopOfTheMap) {
  const CellFrame frame(4, 0.3);
  EXPECT_DOUBLE_EQ(0.15, frame.toPoint({3, 0}).y);
  EXPECT_DOUBLE_EQ(1.05, frame.toPoint({0, 2}).y);
  EXPECT_DOUBLE_EQ(0.75, frame.toPoint({0, 2}).x);
}

TEST(CellFrameTest, ThereAndBackIsTheIdentity) {
  const CellFrame frame(5, 0.37);
  for (int row = -2; row < 7; ++row) {
    for (int col = -2; col < 9; ++col) {
      EXPECT_EQ((Cell{row, col}), frame.toCell(frame.toPoint({row, col})));
    }
  }
}

TEST(CellFrameTest, FollowsTheCornerOfTheMap) {
  const CellFrame frame(4, 0.5, {-10.0, 3.0});
  EXPECT_DOUBLE_EQ(-9.75, frame.toPoint({3, 0}).x);
  EXPECT_DOUBLE_EQ(3.25, frame.toPoint({3, 0}).y);
  for (const Cell cell : {Cell{0, 0}, Cell{3, 7}, Cell{-2, 1}, Cell{5, -3}}) {
    EXPECT_EQ(cell, frame.toCell(frame.toPoint(cell)));
  }
  EXPECT_EQ((Cell{3, 0}), frame.toCell({-9.999, 3.001}));
}

TEST(CellFrameTest, RefusesACornerThatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CellFrame(3, 0.3, {nan, 0.0}), std::invalid_argument);
  EXPECT_THROW(CellFrame(3, 0.3, {0.0, nan}), std::invalid_argument);
}

TEST(CellFrameTest, RefusesSizesThatAreNotPositive) {
  EXPECT_THROW(CellFrame(0, 0.3), std::invalid_argument);
  EXPECT_THROW(CellFrame(3, 0.0), std::invalid_argument);
  EXPECT_THROW(CellFrame(3, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
