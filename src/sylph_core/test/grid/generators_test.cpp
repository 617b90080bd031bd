#include "sylph_core/grid/generators.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "sylph_core/grid/components.hpp"

namespace sylph {
namespace {

double blockedShare(const Grid& grid) {
  return 1.0 - static_cast<double>(grid.freeCellCount()) / grid.size();
}

double meanBlockedShare(const std::function<Grid(Rng&)>& generate) {
  double sum = 0.0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    sum += blockedShare(generate(rng));
  }
  return sum / 20.0;
}

TEST(GeneratorsProperty, FreeCellsAreConnected) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int rows = 1 + static_cast<int>(drawIndex(rng, 40));
    const int cols = 1 + static_cast<int>(drawIndex(rng, 40));
    const int size = 1 + static_cast<int>(drawIndex(rng, 5));
    const double share = drawFraction(rng);
    for (const Grid& grid :
         {randomMap({rows, cols, share}, rng), roomMap({rows, cols, size, 1, share}, rng),
          mazeMap({rows, cols, size, share}, rng)}) {
      EXPECT_EQ(rows, grid.rows());
      EXPECT_EQ(cols, grid.cols());
      EXPECT_EQ(1U, connectedComponents(grid).cells.size()) << grid.toText();
    }
  }
}

TEST(GeneratorsTest, RandomMapHasTheDensityAskedFor) {
  Rng rng(3);
  EXPECT_EQ(1024 - 205, randomMap({32, 32, 0.2}, rng).freeCellCount());
  EXPECT_EQ(900, randomMap({30, 30, 0.0}, rng).freeCellCount());
  EXPECT_EQ(9, randomMap({30, 30, 0.99}, rng).freeCellCount());
  EXPECT_EQ(1, randomMap({3, 3, 0.999}, rng).freeCellCount());
}

TEST(GeneratorsTest, RoomsOfThreeBlockAThirdAndMazesHalf) {
  EXPECT_NEAR(0.333, meanBlockedShare([](Rng& rng) { return roomMap(RoomMapSpec{}, rng); }), 0.01);
  EXPECT_NEAR(0.48, meanBlockedShare([](Rng& rng) { return mazeMap(MazeMapSpec{}, rng); }), 0.01);
  EXPECT_NEAR(0.50, meanBlockedShare([](Rng& rng) {
                return mazeMap({32, 32, 1, 0.0}, rng);
              }),
              0.005);
}

TEST(GeneratorsTest, RoomMapWithoutDoorsToSpareIsATreeOfRooms) {
  Rng rng(5);
  // 3 x 3 rooms of 3 x 3 cells and 8 doors.
  EXPECT_EQ(81 + 8, roomMap({11, 11, 3, 1, 0.0}, rng).freeCellCount());
  EXPECT_EQ(81 + 12, roomMap({11, 11, 3, 1, 1.0}, rng).freeCellCount());
  EXPECT_EQ(81 + 2 * 12, roomMap({11, 11, 3, 2, 1.0}, rng).freeCellCount());
}

TEST(GeneratorsTest, MazeWithoutOpenedWallsHasNoLoop) {
  Rng rng(5);
  const Grid maze = mazeMap({11, 11, 1, 0.0}, rng);
  EXPECT_EQ(36 + 35, maze.freeCellCount());  // 6 x 6 crossings and the edges of a tree on them
  EXPECT_EQ(36 + 60, mazeMap({11, 11, 1, 1.0}, rng).freeCellCount());
}

TEST(GeneratorsTest, TheSameSeedGivesTheSameMap) {
  Rng first(7);
  Rng second(7);
  Rng other(8);
  EXPECT_EQ(randomMap({}, first), randomMap({}, second));
  EXPECT_EQ(roomMap({}, first), roomMap({}, second));
  EXPECT_EQ(mazeMap({}, first), mazeMap({}, second));
  EXPECT_NE(mazeMap({}, first), mazeMap({}, other));
}

TEST(GeneratorsTest, RefusesWhatIsOutOfRange) {
  Rng rng(0);
  EXPECT_THROW(randomMap({0, 10, 0.2}, rng), std::invalid_argument);
  EXPECT_THROW(randomMap({10, 10, 1.0}, rng), std::invalid_argument);
  EXPECT_THROW(randomMap({10, 10, -0.1}, rng), std::invalid_argument);
  EXPECT_THROW(roomMap({10, 10, 0, 1, 0.5}, rng), std::invalid_argument);
  EXPECT_THROW(roomMap({10, 10, 3, 4, 0.5}, rng), std::invalid_argument);
  EXPECT_THROW(roomMap({10, 10, 3, 1, 1.5}, rng), std::invalid_argument);
  EXPECT_THROW(mazeMap({10, 10, 0, 0.5}, rng), std::invalid_argument);
  EXPECT_THROW(mazeMap({10, 10, 1, -0.5}, rng), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
