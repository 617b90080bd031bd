#include "sylph_core/grid/distance_field.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph {
namespace {

TEST(DistanceFieldTest, WalksAroundObstacles) {
  const Grid grid = Grid::fromText("...\n##.\n...\n");
  const DistanceField field(grid, {2, 0});
  EXPECT_EQ(0, field.at({2, 0}));
  EXPECT_EQ(6, field.at({0, 0}));
  EXPECT_EQ(DistanceField::kUnreachable, field.at({1, 0}));
  EXPECT_EQ(DistanceField::kUnreachable, field.at({0, -1}));
}

TEST(DistanceFieldTest, RefusesAGoalOnAnObstacle) {
  EXPECT_THROW(DistanceField(Grid::fromText(".#\n"), {0, 1}), std::invalid_argument);
}

TEST(ShortestPathTest, StartsAtTheStartAndEndsAtTheGoal) {
  const DistanceField field(Grid::fromText("...\n##.\n...\n"), {2, 0});
  const std::vector<Cell> expected = {{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}};
  EXPECT_EQ(expected, shortestPath(field, {0, 0}));
}

TEST(ShortestPathTest, IsEmptyWhenTheGoalIsWalledOff) {
  const DistanceField field(Grid::fromText(".#.\n"), {0, 2});
  EXPECT_TRUE(shortestPath(field, {0, 0}).empty());
}

}  // namespace
}  // namespace sylph
