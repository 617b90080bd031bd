#include "sylph_core/grid/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/generators.hpp"
#include "sylph_core/grid/rng.hpp"

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
  const Grid grid = Grid::fromText(".#\n");
  EXPECT_THROW(DistanceField(grid, {0, 1}), std::invalid_argument);
}

TEST(DistanceFieldProperty, AnswersDoNotDependOnTheOrderOfQuestions) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Grid grid = randomMap({9, 11, 0.35}, rng);
    std::vector<Cell> cells = grid.freeCells();
    const Cell goal = cells[drawIndex(rng, cells.size())];
    const DistanceField complete(grid, goal);
    complete.complete();
    const DistanceField asked(grid, goal);
    shuffle(cells, rng);
    for (const Cell& cell : cells) {
      EXPECT_EQ(complete.at(cell), asked.at(cell));
      // One more than the nearest cell beside it.
      int least = DistanceField::kUnreachable;
      for (const Action action : kActions) {
        if (action != Action::Stay) {
          least = std::min(least, asked.at(neighbor(cell, action)));
        }
      }
      if (cell != goal && least != DistanceField::kUnreachable) {
        EXPECT_EQ(least + 1, asked.at(cell));
      }
    }
    EXPECT_EQ(0, asked.at(goal));
  }
}

TEST(ShortestPathTest, StartsAtTheStartAndEndsAtTheGoal) {
  const Grid grid = Grid::fromText("...\n##.\n...\n");
  const DistanceField field(grid, {2, 0});
  const std::vector<Cell> expected = {{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}};
  EXPECT_EQ(expected, shortestPath(field, {0, 0}));
}

TEST(ShortestPathTest, IsEmptyWhenTheGoalIsWalledOff) {
  const Grid grid = Grid::fromText(".#.\n");
  const DistanceField field(grid, {0, 2});
  EXPECT_TRUE(shortestPath(field, {0, 0}).empty());
}

}  // namespace
}  // namespace sylph
