#include "sylph_planner_node/send_request.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "mission/small_lab.hpp"

namespace sylph_planner_node {
namespace {

std::string errorOf(const std::vector<std::string>& arguments) {
  try {
    readGoals(arguments, sylph::smallLab());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

SendRequest request() {
  SendRequest request;
  request.goals = {{"robot_1", {1, 0}}};
  return request;
}

TEST(ReadGoalsTest, TakesRowAndColumnOfEachRobot) {
  EXPECT_EQ((sylph::RobotGoals{{"robot_0", {2, 4}}, {"robot_2", {0, 1}}}),
            readGoals({"robot_2:=0,1", "robot_0:=2,4"}, sylph::smallLab()));
}

TEST(ReadGoalsTest, RefusesOtherForms) {
  for (const std::string argument :
       {"robot_0", "robot_0=1,2", ":=1,2", "robot_0:=1", "robot_0:=1,2,3", "robot_0:=1,x",
        "robot_0:=1.5,2", "robot_0:=99999999999,1", "robot_0:= 1,2", "robot_0:=1,+2", "robot_0:=1,",
        ""}) {
    EXPECT_EQ("'" + argument + "': a goal must be ROBOT:=ROW,COL, such as robot_3:=4,7",
              errorOf({argument}));
  }
}

TEST(ReadGoalsTest, RefusesRobotsThatThereAreNotOrTwice) {
  EXPECT_EQ("unknown robot 'robot2'; the nearest names are robot_2, robot_0",
            errorOf({"robot2:=1,0"}));
  EXPECT_EQ("robot robot_0 is named twice", errorOf({"robot_0:=1,0", "robot_0:=0,1"}));
}

TEST(ReadGoalsTest, RefusesGoalsOfNoUse) {
  EXPECT_EQ("goal (3,0) of robot_0 lies outside the map of 3 x 5 cells", errorOf({"robot_0:=3,0"}));
  EXPECT_EQ("goal (1,1) of robot_0 lies on an obstacle", errorOf({"robot_0:=1,1"}));
  EXPECT_EQ("goal (0,1) of robot_1 is also the goal of robot_0",
            errorOf({"robot_0:=0,1", "robot_1:=0,1"}));
}

TEST(ToExperimentTest, LetsRobotsWithoutGoalStay) {
  const sylph::Configuration cells = {{0, 1}, {2, 3}, {0, 4}};
  SendRequest asked = request();
  asked.planner = "pibt";
  asked.time_limit_s = 0.5;
  asked.seed = 9;
  const sylph::Experiment mission = toExperiment(asked, sylph::smallLab(), cells);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cells[i], mission.robots[i].start);
  }
  EXPECT_EQ((sylph::Cell{0, 1}), mission.robots[0].goal);
  EXPECT_EQ((sylph::Cell{1, 0}), mission.robots[1].goal);
  EXPECT_EQ("pibt", mission.planning.planner);
  EXPECT_EQ(0.5, mission.planning.time_limit_s);
  EXPECT_EQ(9U, mission.seed);
}

}  // namespace
}  // namespace sylph_planner_node
