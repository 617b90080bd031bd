#include "sylph_core/grid/grid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sylph_core/grid/components.hpp"

namespace sylph {
namespace {

TEST(GridTest, ReadsRowsFromTheTop) {
  const Grid grid = Grid::fromText("..#\n...\n");
  EXPECT_EQ(2, grid.rows());
  EXPECT_EQ(3, grid.cols());
  EXPECT_FALSE(grid.isFree({0, 2}));
  EXPECT_TRUE(grid.isFree({1, 2}));
  EXPECT_EQ(5, grid.freeCellCount());
}

TEST(GridTest, TextThereAndBackIsTheIdentity) {
  const std::string text = "..#\n.#.\n";
  EXPECT_EQ(text, Grid::fromText(text).toText());
}

TEST(GridTest, OutsideIsNotFree) {
  const Grid grid(2, 3);
  EXPECT_FALSE(grid.isFree({-1, 0}));
  EXPECT_FALSE(grid.isFree({0, 3}));
  EXPECT_FALSE(grid.isFree({2, 0}));
}

TEST(GridTest, RefusesBadTextAndSizes) {
  EXPECT_THROW(Grid::fromText(""), std::invalid_argument);
  EXPECT_THROW(Grid::fromText("..\n.\n"), std::invalid_argument);
  EXPECT_THROW(Grid::fromText(".x\n"), std::invalid_argument);
  EXPECT_THROW(Grid(0, 3), std::invalid_argument);
  EXPECT_THROW(Grid(3, Grid::kMaxSide + 1), std::invalid_argument);
  EXPECT_THROW(Grid(2, 2).setObstacle({2, 0}), std::out_of_range);
}

TEST(ComponentsTest, LargestComesFirst) {
  const Components components = connectedComponents(Grid::fromText(".#..\n##..\n"));
  ASSERT_EQ(2U, components.cells.size());
  EXPECT_EQ((std::vector<Cell>{{0, 2}, {0, 3}, {1, 2}, {1, 3}}), components.cells[0]);
  EXPECT_EQ((std::vector<int>{1, -1, 0, 0, -1, -1, 0, 0}), components.label);
}

}  // namespace
}  // namespace sylph
