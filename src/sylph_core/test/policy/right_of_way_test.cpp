#include "sylph_core/policy/right_of_way.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

#include "sylph_core/grid/grid.hpp"

namespace sylph {
namespace {

struct Traveller {
  Cell cell;
  Cell goal;
  float svo_deg;
};

class RightOfWayTest : public ::testing::Test {
 protected:
  RightOfWay see(const std::string& map, const std::vector<Traveller>& travellers) {
    const Grid grid = Grid::fromText(map);
    map_.emplace_back(grid, 1);
    std::vector<DistanceField>& distances = distances_.emplace_back();
    Configuration cells;
    std::vector<float> svo_deg;
    for (const Traveller& traveller : travellers) {
      distances.emplace_back(grid, traveller.goal);
      cells.push_back(traveller.cell);
      svo_deg.push_back(traveller.svo_deg);
    }
    map_.back().place(cells);
    RightOfWay seen(map_.back(), distances);
    seen.setStates(cells, svo_deg);
    return seen;
  }

  std::deque<OccupancyMap> map_;
  std::deque<std::vector<DistanceField>> distances_;
};

using Directions = RightOfWay::Directions;
constexpr Directions kNone = {false, false, false, false};
constexpr Directions kEast = {false, true, false, false};

TEST_F(RightOfWayTest, TwoInACorridorHaveToSwapIfThereIsAJunctionBehind) {
  const std::vector<Traveller> meeting = {{{1, 2}, {1, 5}, 10.F}, {{1, 3}, {1, 0}, 20.F}};
  const RightOfWay behind =
      see("#.####\n"
          "......\n"
          "######\n",
          meeting);
  EXPECT_EQ(kEast, behind.swaps(0));
  EXPECT_EQ(kNone, behind.swaps(1)) << "a dead end behind it";
  const RightOfWay nowhere =
      see("######\n"
          "......\n"
          "######\n",
          meeting);
  EXPECT_EQ(kNone, nowhere.swaps(0));
  EXPECT_EQ(kNone, nowhere.swaps(1));
  const RightOfWay open = see("......\n......\n......\n", meeting);
  EXPECT_EQ(kNone, open.swaps(0)) << "no need where one can pass";
}

TEST_F(RightOfWayTest, DesiredMovesComeCloserAndEndOnTheGoal) {
  const RightOfWay seen = see("...\n", {{{0, 0}, {0, 2}, 0.F}, {{0, 1}, {0, 1}, 45.F}});
  EXPECT_EQ(kEast, seen.desired(0));
  EXPECT_EQ(kNone, seen.desired(1));
}

TEST_F(RightOfWayTest, PushesGoFromAgentToAgentAndOnlyUpwards) {
  // 0 pushes 1, which is home and can only go on east, where 2 rests; 3 is out of the way.
  const RightOfWay seen =
      see("######\n"
          "......\n"
          "######\n",
          {{{1, 0}, {1, 5}, 5.F},
           {{1, 1}, {1, 1}, 45.F},
           {{1, 2}, {1, 2}, 45.F},
           {{1, 4}, {1, 4}, 45.F}});
  EXPECT_EQ(5.F, seen.inheritedSvoDeg(0));
  EXPECT_EQ(5.F, seen.inheritedSvoDeg(1));
  EXPECT_EQ(5.F, seen.inheritedSvoDeg(2));
  EXPECT_EQ(45.F, seen.inheritedSvoDeg(3)) << "2 has a free cell to go to";
}

TEST_F(RightOfWayTest, WhoIsMoreSelfishIsNotPushed) {
  const RightOfWay seen = see("....\n", {{{0, 0}, {0, 3}, 40.F}, {{0, 1}, {0, 3}, 10.F}});
  EXPECT_EQ(10.F, seen.inheritedSvoDeg(1));
  EXPECT_EQ(40.F, seen.inheritedSvoDeg(0));
}

}  // namespace
}  // namespace sylph
