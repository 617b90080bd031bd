#include "sylph_core/mapf/random_instance.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph {
namespace {

TEST(RandomInstanceProperty, IsAlwaysValid) {
  // Two components; as many agents as there are free cells is the hardest case.
  const Grid grid = Grid::fromText("..#..\n..#..\n.##..\n");
  for (unsigned seed = 0; seed < 50; ++seed) {
    Rng rng(seed);
    for (const int agents : {1, 5, grid.freeCellCount()}) {
      EXPECT_NO_THROW(requireValid(randomInstance(grid, agents, {}, rng)));
    }
  }
}

TEST(RandomInstanceTest, TheSameSeedGivesTheSameInstance) {
  Rng first(3);
  Rng second(3);
  const Instance a = randomInstance(Grid(8, 8), 10, {}, first);
  const Instance b = randomInstance(Grid(8, 8), 10, {}, second);
  EXPECT_EQ(a.starts, b.starts);
  EXPECT_EQ(a.goals, b.goals);
}

TEST(RandomInstanceTest, DrawsTheSameCellsOnEveryComputer) {
  // Fixed by the definition of std::mt19937 and of shuffle(): computers of a lab must agree.
  Rng rng(1);
  EXPECT_EQ((Configuration{{1, 2}, {2, 1}, {2, 0}}), drawCells(Grid(4, 4), 3, rng));
}

TEST(RandomInstanceTest, RefusesMoreAgentsThanFreeCells) {
  Rng rng(0);
  EXPECT_THROW(randomInstance(Grid::fromText("..#\n"), 3, {}, rng), std::invalid_argument);
  EXPECT_THROW(randomInstance(Grid(2, 2), 0, {}, rng), std::invalid_argument);
  EXPECT_THROW(drawReachableCells(Grid(2, 2), {{0, 0}, {0, 0}}, rng), std::invalid_argument);
  EXPECT_THROW(drawReachableCells(Grid(2, 2), {{2, 0}}, rng), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
