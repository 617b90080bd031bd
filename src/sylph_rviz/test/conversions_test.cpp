#include "sylph_rviz/conversions.hpp"

#include <gtest/gtest.h>

namespace sylph_rviz {
namespace {

TEST(FootprintTest, ThereAndBackIsTheIdentity) {
  RobotView robot;
  robot.name = "robot_2";
  robot.length_m = 0.42;
  robot.width_m = 0.31;
  const geometry_msgs::PolygonStamped message = footprintOf(robot);
  EXPECT_EQ("robot_2", message.header.frame_id);
  RobotView copy;
  setFootprint(copy, message);
  EXPECT_NEAR(0.42, copy.length_m, 1e-6);
  EXPECT_NEAR(0.31, copy.width_m, 1e-6);
}

TEST(FootprintTest, WithoutExtentChangesNothing) {
  RobotView robot;
  setFootprint(robot, geometry_msgs::PolygonStamped());
  EXPECT_DOUBLE_EQ(0.23, robot.length_m);
}

TEST(ExtentTest, NeedsCellsAndAResolution) {
  nav_msgs::OccupancyGrid message;
  EXPECT_FALSE(extentOf(message));
  message.info.width = 7;
  message.info.height = 5;
  EXPECT_FALSE(extentOf(message));
  message.info.resolution = 0.5F;
  const auto extent = extentOf(message);
  ASSERT_TRUE(extent);
  EXPECT_EQ(5, extent->rows);
  EXPECT_EQ(7, extent->cols);
  EXPECT_DOUBLE_EQ(0.5, extent->cell_size_m);
  message.info.origin.position.x = -10.5;
  message.info.origin.position.y = 3.0;
  Scene scene;
  scene.map = extentOf(message);
  EXPECT_DOUBLE_EQ(-10.25, centerOf(scene, {4, 0})->x);
  EXPECT_DOUBLE_EQ(3.25, centerOf(scene, {4, 0})->y);
}

TEST(SceneOfTest, TakesRobotsGoalsAndMapFromTheExperiment) {
  sylph::Experiment experiment;
  experiment.grid = sylph::Grid(3, 4);
  experiment.cell_size_m = 0.4;
  experiment.corner = {1.0, -2.0};
  sylph::RobotSpec robot;
  robot.name = "anna";
  robot.length_m = 0.3;
  robot.goal = {2, 1};
  experiment.robots = {robot};
  const Scene scene = sceneOf(experiment);
  ASSERT_EQ(1U, scene.robots.size());
  EXPECT_EQ("anna", scene.robots[0].name);
  EXPECT_DOUBLE_EQ(0.3, scene.robots[0].length_m);
  EXPECT_EQ((sylph::Cell{2, 1}), scene.robots[0].goal);
  EXPECT_EQ(4, scene.map->cols);
  EXPECT_DOUBLE_EQ(0.4, scene.map->cell_size_m);
  EXPECT_DOUBLE_EQ(1.2, centerOf(scene, {2, 0})->x);
  EXPECT_DOUBLE_EQ(-1.8, centerOf(scene, {2, 0})->y);
}

}  // namespace
}  // namespace sylph_rviz
