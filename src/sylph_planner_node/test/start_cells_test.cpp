#include "sylph_planner_node/start_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "small_lab.hpp"
#include "sylph_ros/conversions.hpp"

namespace sylph_planner_node {
namespace {

constexpr double kNow_s = 100.0;
constexpr double kTimeout_s = 0.5;

MeasuredPoses posesInStarts() {
  const Mission mission = smallMission();
  MeasuredPoses poses;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    poses[mission.robots[i]] = {poseIn(mission, smallStarts()[i]), kNow_s - 0.1};
  }
  return poses;
}

std::string failureWith(const MeasuredPoses& poses) {
  return failureOf([&] { startCells(smallMission(), poses, kNow_s, kTimeout_s); });
}

TEST(StartCellsTest, AreTheCellsThatContainThePoses) {
  MeasuredPoses poses = posesInStarts();
  poses["robot_0"].pose.pose.position.x += 0.14;  // still in (0,0)
  poses["robot_1"].pose.pose.position.y += 0.16;  // from (2,4) over the edge to (1,4)
  EXPECT_EQ((sylph::Configuration{{0, 0}, {1, 4}, {0, 4}}),
            startCells(smallMission(), poses, kNow_s, kTimeout_s));
}

TEST(StartCellsTest, FollowTheCornerOfTheMap) {
  Mission mission = smallMission();
  mission.corner = {-10.0, 5.0};
  MeasuredPoses poses = posesInStarts();
  for (auto& [robot, measured] : poses) {
    measured.pose.pose.position.x -= 10.0;
    measured.pose.pose.position.y += 5.0;
  }
  EXPECT_EQ(smallStarts(), startCells(mission, poses, kNow_s, kTimeout_s));
}

TEST(StartCellsTest, NameTheRobotWithoutPose) {
  MeasuredPoses poses = posesInStarts();
  poses.erase("robot_1");
  EXPECT_EQ("2: no pose of robot_1 has come", failureWith(poses));
}

TEST(StartCellsTest, NameTheRobotWithAStalePose) {
  MeasuredPoses poses = posesInStarts();
  poses["robot_2"].received_s = kNow_s - 0.8;
  EXPECT_EQ("2: the pose of robot_2 came 0.80 s ago: at most 0.50 s are allowed",
            failureWith(poses));
}

TEST(StartCellsTest, NameTheRobotOutsideTheMap) {
  MeasuredPoses poses = posesInStarts();
  poses["robot_0"].pose.pose.position.x = -0.1;
  EXPECT_EQ("2: robot_0 at (-0.10, 0.75) m is in cell (0,-1), outside the map", failureWith(poses));
}

TEST(StartCellsTest, NameTheRobotOnAnObstacle) {
  MeasuredPoses poses = posesInStarts();
  poses["robot_0"].pose = poseIn(smallMission(), {1, 2});
  EXPECT_EQ("2: robot_0 at (0.75, 0.45) m is in cell (1,2), which is an obstacle",
            failureWith(poses));
}

TEST(StartCellsTest, NameBothRobotsInOneCell) {
  MeasuredPoses poses = posesInStarts();
  poses["robot_2"].pose = poses["robot_0"].pose;
  EXPECT_EQ("2: robot_2 at (0.15, 0.75) m is in cell (0,0), where robot_0 is too",
            failureWith(poses));
}

TEST(StartCellsTest, RefuseAnotherFrameAndNumbersThatAreNone) {
  MeasuredPoses poses = posesInStarts();
  poses["robot_0"].pose.header.frame_id = "optitrack";
  EXPECT_EQ("2: the pose of robot_0 is in frame 'optitrack': it must be 'map'", failureWith(poses));
  poses = posesInStarts();
  poses["robot_0"].pose.pose.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ("2: the pose of robot_0 is not a number", failureWith(poses));
}

TEST(CellsOfBystandersTest, AreThoseThatTheFootprintTouches) {
  Mission mission = smallMission();
  mission.robots = {"robot_0"};
  mission.goals.resize(1);
  MeasuredPoses poses = posesInStarts();
  poses["robot_1"].pose.pose.position.x -= 0.1;  // 0.23 m long: reaches from (2,4) into (2,3)
  poses["robot_2"].received_s = kNow_s - 10.0;   // nobody knows where it is
  EXPECT_EQ((std::vector<sylph::Cell>{{2, 3}, {2, 4}}),
            cellsOfBystanders(mission, smallLab(), poses, kNow_s, kTimeout_s));
}

TEST(CellsOfBystandersTest, FollowTheHeading) {
  Mission mission = smallMission();
  mission.robots = {"robot_0", "robot_2"};
  mission.goals.resize(2);
  MeasuredPoses poses = posesInStarts();
  // Turned by 90 degrees the robot reaches 0.115 m along y, not 0.1 m.
  poses["robot_1"].pose.pose.orientation = sylph_ros::quaternionFromYaw(std::acos(0.0));
  poses["robot_1"].pose.pose.position.y += 0.04;
  EXPECT_EQ((std::vector<sylph::Cell>{{1, 4}, {2, 4}}),
            cellsOfBystanders(mission, smallLab(), poses, kNow_s, kTimeout_s));
}

}  // namespace
}  // namespace sylph_planner_node
