#include "sylph_core/mission/replanning.hpp"

#include <gtest/gtest.h>

#include "small_lab.hpp"

namespace sylph {
namespace {

RobotExecution robotIn(const std::string& name, const Cell& cell) {
  RobotExecution robot;
  robot.robot = name;
  robot.cell = cell;
  robot.held_cells = {robot.cell};
  return robot;
}

/// Robot 1 is lost between two cells.
AdgState cutWithRobot1Lost(const std::vector<Cell>& held_cells) {
  AdgState cut;
  cut.robots = {robotIn("robot_0", {0, 1}), robotIn("robot_1", held_cells.front()),
                robotIn("robot_2", {0, 3})};
  cut.robots[1].condition = RobotCondition::Lost;
  cut.robots[1].held_cells = held_cells;
  return cut;
}

TEST(RestOfMissionTest, LeavesTheLostRobotOutAndItsCellsBlocked) {
  const RestOfMission rest = restOfMission(smallMission(), cutWithRobot1Lost({{2, 3}, {2, 2}}));
  EXPECT_EQ((std::vector<std::string>{"robot_0", "robot_2"}), rest.robots);
  EXPECT_EQ((Configuration{{0, 1}, {0, 3}}), rest.instance.starts);
  EXPECT_EQ((Configuration{{0, 4}, {0, 0}}), rest.instance.goals);
  EXPECT_FALSE(rest.instance.grid.isFree({2, 3}));
  EXPECT_FALSE(rest.instance.grid.isFree({2, 2}));
  EXPECT_TRUE(rest.instance.grid.isFree({2, 1}));
  EXPECT_FALSE(rest.instance.motion.rotations);
  EXPECT_TRUE(rest.given_up.empty());
}

TEST(RestOfMissionTest, SendsARobotNextToAGoalThatIsTaken) {
  const RestOfMission rest = restOfMission(smallMission(), cutWithRobot1Lost({{0, 4}}));
  EXPECT_EQ((Cell{0, 3}), rest.instance.goals[0]);
  EXPECT_EQ((Cell{0, 0}), rest.instance.goals[1]);
  ASSERT_EQ(1U, rest.given_up.size());
  EXPECT_EQ("robot_0 cannot reach (0,4) any more and goes to (0,3)", rest.given_up.front());
}

TEST(RestOfMissionTest, KeepsRobotsOnTheirSideOfABlockedWay) {
  // Columns 0 ... 2 and 3 ... 4 of the small map hang together by (0,2) and (2,2) alone.
  const RestOfMission rest = restOfMission(smallMission(), cutWithRobot1Lost({{0, 2}, {2, 2}}));
  EXPECT_EQ((Configuration{{0, 1}, {0, 3}}), rest.instance.goals);
  EXPECT_EQ(2U, rest.given_up.size());
}

TEST(RestOfMissionTest, RefusesACutThatDoesNotFit) {
  AdgState cut = cutWithRobot1Lost({{2, 2}});
  cut.robots.pop_back();
  EXPECT_EQ("4: cannot plan the rest: the central node does not know robot_2",
            failureOf([&] { restOfMission(smallMission(), cut); }));
  cut = cutWithRobot1Lost({{0, 1}});
  EXPECT_EQ("4: cannot plan the rest: robot_0 is reported in cell (0,1), which is not free",
            failureOf([&] { restOfMission(smallMission(), cut); }));
  cut = cutWithRobot1Lost({{2, 2}});
  cut.robots[0].condition = RobotCondition::Lost;
  cut.robots[2].condition = RobotCondition::Lost;
  EXPECT_EQ("4: cannot plan the rest: all robots are lost",
            failureOf([&] { restOfMission(smallMission(), cut); }));
}

}  // namespace
}  // namespace sylph
