#include "sylph_core/mission/goal_judge.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

/// A room with a door to another one, and a cell that nobody reaches.
Grid map() {
  return Grid::fromText(
      "...#..#.\n"
      "......##\n"
      "...#....\n");
}

std::string refusal(const Cell& goal, const CellOwners& bystanders = {},
                    const CellOwners& taken = {}) {
  return GoalJudge(map(), bystanders).refusal("robot_0", goal, Cell{0, 0}, taken);
}

TEST(GoalJudgeTest, TakesAFreeCellInReach) {
  EXPECT_EQ("", refusal({2, 7}));
  EXPECT_EQ("", refusal({0, 0})) << "it may stay";
}

TEST(GoalJudgeTest, RefusesCellsThatNobodyCanHave) {
  EXPECT_EQ("goal (3,0) of robot_0 lies outside the map of 3 x 8 cells", refusal({3, 0}));
  EXPECT_EQ("goal (0,-1) of robot_0 lies outside the map of 3 x 8 cells", refusal({0, -1}));
  EXPECT_EQ("goal (0,3) of robot_0 lies on an obstacle", refusal({0, 3}));
}

TEST(GoalJudgeTest, RefusesTheGoalOfAnother) {
  EXPECT_EQ("goal (2,7) of robot_0 is also the goal of robot_1",
            refusal({2, 7}, {}, {{{2, 7}, "robot_1"}}));
  EXPECT_EQ("", refusal({2, 7}, {}, {{{2, 7}, "robot_0"}}));
}

TEST(GoalJudgeTest, RefusesWhereABystanderStands) {
  EXPECT_EQ("goal (2,7) of robot_0 is where robot_5 stands, which has no part in the mission",
            refusal({2, 7}, {{{2, 7}, "robot_5"}}));
}

TEST(GoalJudgeTest, RefusesACellThatIsWalledOff) {
  EXPECT_EQ("goal (0,7) of robot_0 cannot be reached from its cell (0,0)", refusal({0, 7}));
}

TEST(GoalJudgeTest, NamesTheBystandersThatStandInTheWay) {
  EXPECT_EQ(
      "goal (2,7) of robot_0 cannot be reached from its cell (0,0) past robots without part in the "
      "mission: robot_5",
      refusal({2, 7}, {{{1, 3}, "robot_5"}, {{0, 5}, "robot_6"}}));
}

TEST(GoalJudgeTest, DoesNotAskForTheWayOfARobotThatIsNotSeen) {
  EXPECT_EQ("", GoalJudge(map()).refusal("robot_0", {0, 7}, std::nullopt));
  EXPECT_NE("", GoalJudge(map()).refusal("robot_0", {0, 6}, std::nullopt));
}

TEST(UnknownRobotTest, NamesTheNearest) {
  EXPECT_EQ("unknown robot 'robot3'; the nearest names are robot_3, robot_1",
            unknownRobot("robot3", {"alpha", "robot_1", "robot_3"}));
}

}  // namespace
}  // namespace sylph
