#include "sylph_core/mission/start_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "small_lab.hpp"

namespace sylph {
namespace {

std::string failureWith(const RobotPoses& poses) {
  return failureOf([&] { startCells(smallMission(), poses); });
}

TEST(StartCellsTest, AreTheCellsThatContainThePoses) {
  RobotPoses poses = posesInStarts();
  poses["robot_0"].pose.x_m += 0.14;  // still in (0,0)
  poses["robot_1"].pose.y_m += 0.16;  // from (2,4) over the edge to (1,4)
  EXPECT_EQ((Configuration{{0, 0}, {1, 4}, {0, 4}}), startCells(smallMission(), poses));
}

TEST(StartCellsTest, FollowTheCornerOfTheMap) {
  Mission mission = smallMission();
  mission.corner = {-10.0, 5.0};
  RobotPoses poses = posesInStarts();
  for (auto& [robot, measured] : poses) {
    measured.pose.x_m -= 10.0;
    measured.pose.y_m += 5.0;
  }
  EXPECT_EQ(smallStarts(), startCells(mission, poses));
}

TEST(StartCellsTest, NameTheRobotWithoutPose) {
  RobotPoses poses = posesInStarts();
  poses.erase("robot_1");
  EXPECT_EQ("2: no pose of robot_1 has come", failureWith(poses));
}

TEST(StartCellsTest, NameEachRobotThatIsAtFault) {
  RobotPoses poses = posesInStarts();
  poses.erase("robot_0");
  poses["robot_2"].fault = "is not a number";
  EXPECT_EQ("2: no pose of robot_0 has come\nthe pose of robot_2 is not a number",
            failureWith(poses));
}

TEST(StartCellsTest, SayWhatIsWrongWithAPose) {
  RobotPoses poses = posesInStarts();
  poses["robot_2"].fault = "came 0.80 s ago: at most 0.50 s are allowed";
  EXPECT_EQ("2: the pose of robot_2 came 0.80 s ago: at most 0.50 s are allowed",
            failureWith(poses));
}

TEST(StartCellsTest, NameTheRobotOutsideTheMap) {
  RobotPoses poses = posesInStarts();
  poses["robot_0"].pose.x_m = -0.1;
  EXPECT_EQ("2: robot_0 at (-0.10, 0.75) m is in cell (0,-1), outside the map", failureWith(poses));
}

TEST(StartCellsTest, NameTheRobotOnAnObstacle) {
  RobotPoses poses = posesInStarts();
  poses["robot_0"].pose = pose2dIn(smallMission(), {1, 2});
  EXPECT_EQ("2: robot_0 at (0.75, 0.45) m is in cell (1,2), which is an obstacle",
            failureWith(poses));
}

TEST(StartCellsTest, NameBothRobotsInOneCell) {
  RobotPoses poses = posesInStarts();
  poses["robot_2"].pose = poses["robot_0"].pose;
  EXPECT_EQ("2: robot_2 at (0.15, 0.75) m is in cell (0,0), where robot_0 is too",
            failureWith(poses));
}

TEST(UnseenBystandersTest, AreNamedOneByOne) {
  Mission mission = smallMission();
  mission.robots = {"robot_0"};
  mission.goals.resize(1);
  RobotPoses poses = posesInStarts();
  const std::vector<RobotSpec> lab = smallLab().robots;
  EXPECT_TRUE(unseenBystanders(mission, lab, poses).empty());
  poses.erase("robot_1");
  poses["robot_2"].fault = "is not a number";
  EXPECT_EQ(
      (std::vector<std::string>{
          "robot_1 has no part in the mission, but might stand in its way: no pose of it has come",
          "robot_2 has no part in the mission, but might stand in its way: its pose is not a "
          "number"}),
      unseenBystanders(mission, lab, poses));
}

TEST(CellsOfBystandersTest, AreThoseThatTheFootprintTouches) {
  Mission mission = smallMission();
  mission.robots = {"robot_0"};
  mission.goals.resize(1);
  RobotPoses poses = posesInStarts();
  poses["robot_1"].pose.x_m -= 0.1;   // 0.23 m long: reaches from (2,4) into (2,3)
  poses["robot_2"].fault = "is old";  // nobody knows where it is
  EXPECT_EQ((CellOwners{{{2, 3}, "robot_1"}, {{2, 4}, "robot_1"}}),
            cellsOfBystanders(mission, smallLab().robots, poses, 0.0));
}

TEST(CellsOfBystandersTest, AreThoseThatAreTooNearAsWell) {
  Mission mission = smallMission();
  mission.robots = {"robot_0", "robot_2"};
  mission.goals.resize(2);
  RobotPoses poses = posesInStarts();
  poses["robot_1"].pose.x_m -= 0.03;  // 5 mm within its cell (2,4)
  EXPECT_EQ((CellOwners{{{2, 4}, "robot_1"}}),
            cellsOfBystanders(mission, smallLab().robots, poses, 0.004));
  EXPECT_EQ((CellOwners{{{2, 3}, "robot_1"}, {{2, 4}, "robot_1"}}),
            cellsOfBystanders(mission, smallLab().robots, poses, 0.006));
}

TEST(CellsOfBystandersTest, FollowTheHeading) {
  Mission mission = smallMission();
  mission.robots = {"robot_0", "robot_2"};
  mission.goals.resize(2);
  RobotPoses poses = posesInStarts();
  // Turned by 90 degrees the robot reaches 0.115 m along y, not 0.1 m.
  poses["robot_1"].pose.yaw_rad = std::acos(0.0);
  poses["robot_1"].pose.y_m += 0.04;
  EXPECT_EQ((CellOwners{{{1, 4}, "robot_1"}, {{2, 4}, "robot_1"}}),
            cellsOfBystanders(mission, smallLab().robots, poses, 0.0));
}

}  // namespace
}  // namespace sylph
