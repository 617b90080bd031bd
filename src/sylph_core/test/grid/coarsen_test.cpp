#include "sylph_core/grid/coarsen.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

TEST(CoarsenTest, ACellIsFreeIfItsWholeSquareIs) {
  const Grid fine = Grid::fromText(
      "......#\n"
      ".......\n"
      "..#....\n"
      ".......\n"
      "....#..\n");
  // Two by two from the lower left corner: the top row and the right column are left over.
  EXPECT_EQ(Grid::fromText(".#.\n..#\n"), coarsened(fine, 0.1, 0.2, 0.0));
  EXPECT_EQ(fine, coarsened(fine, 0.1, 0.1, 0.0));
}

TEST(CoarsenTest, TheMarginGrowsTheSquare) {
  const Grid fine = Grid::fromText(
      ".........\n"
      ".........\n"
      ".........\n"
      "...#.....\n"
      ".........\n"
      ".........\n"
      ".........\n"
      ".........\n"
      ".........\n");
  EXPECT_EQ(Grid::fromText("...\n.#.\n...\n"), coarsened(fine, 0.1, 0.3, 0.0));
  // The edge of the map is nothing that is known to be free.
  EXPECT_EQ(Grid::fromText("###\n###\n###\n"), coarsened(fine, 0.1, 0.3, 0.02));
  Grid wide(15, 15);
  wide.setObstacle({6, 7});
  EXPECT_EQ(Grid::fromText("#####\n#.#.#\n#.#.#\n#...#\n#####\n"), coarsened(wide, 0.1, 0.3, 0.02));
}

TEST(CoarsenTest, NeedsNoWholeMultiple) {
  // Squares of 2.5: the middle column of small cells belongs to both.
  EXPECT_EQ(Grid::fromText("..\n"), coarsened(Grid(3, 5), 0.04, 0.1, 0.0));
  Grid fine(3, 5);
  fine.setObstacle({1, 2});
  EXPECT_EQ(Grid::fromText("##\n"), coarsened(fine, 0.04, 0.1, 0.0));
  Grid beside(3, 5);
  beside.setObstacle({1, 3});
  EXPECT_EQ(Grid::fromText(".#\n"), coarsened(beside, 0.04, 0.1, 0.0));
}

TEST(CoarsenTest, RoundingLosesNoCell) {
  for (const double small_m : {0.01, 0.025, 0.03, 0.05, 0.1}) {
    for (const int factor : {1, 2, 3, 6, 7, 12}) {
      const Grid coarse = coarsened(Grid(10 * factor, 12 * factor), small_m, small_m * factor, 0.0);
      EXPECT_EQ(Grid(10, 12), coarse) << small_m << " times " << factor;
    }
  }
}

TEST(CoarsenProperty, NoPointOfAGrownFreeCellLiesOnAnObstacle) {
  const auto drawCell = [](const Grid& grid, Rng& rng) {
    return grid.cellAt(static_cast<int>(drawIndex(rng, static_cast<std::size_t>(grid.size()))));
  };
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    Grid fine(20 + static_cast<int>(drawIndex(rng, 20)), 20 + static_cast<int>(drawIndex(rng, 20)));
    for (int obstacle = 0; obstacle < 20; ++obstacle) {
      fine.setObstacle(drawCell(fine, rng));
    }
    const double large_m = drawBetween(rng, 0.05, 0.25);
    const double margin_m = drawBetween(rng, 0.0, 0.03);
    const Grid coarse = coarsened(fine, 0.05, large_m, margin_m);
    const CellFrame coarse_frame(coarse, large_m);
    const CellFrame fine_frame(fine, 0.05);
    for (int point = 0; point < 2000; ++point) {
      const Cell cell = drawCell(coarse, rng);
      const double reach_m = 0.999 * (large_m / 2.0 + margin_m);
      Point place = coarse_frame.toPoint(cell);
      place.x += drawBetween(rng, -reach_m, reach_m);
      place.y += drawBetween(rng, -reach_m, reach_m);
      ASSERT_TRUE(!coarse.isFree(cell) || fine.isFree(fine_frame.toCell(place)));
    }
  }
}

TEST(CoarsenTest, RefusesLengthsOutOfBounds) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [small_m, large_m, margin_m] : {std::tuple{0.0, 0.3, 0.0},
                                                   {0.3, 0.2, 0.0},
                                                   {nan, 0.3, 0.0},
                                                   {0.1, nan, 0.0},
                                                   {0.1, 0.3, -0.1},
                                                   {0.1, 0.3, nan},
                                                   {0.1, 1.0, 0.0}}) {
    EXPECT_THROW(coarsened(Grid(5, 5), small_m, large_m, margin_m), std::invalid_argument)
        << small_m << " " << large_m << " " << margin_m;
  }
}

}  // namespace
}  // namespace sylph
