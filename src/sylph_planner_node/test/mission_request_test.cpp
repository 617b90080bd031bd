#include "sylph_planner_node/mission_request.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mission/small_lab.hpp"
#include "sylph_ros/missions.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::ExecuteMissionGoal;
using sylph_ros::toGoal;

sylph::Mission read(const ExecuteMissionGoal& goal, const sylph::Experiment& lab) {
  Weights weights(lab.planning.weights_path);
  return readMission(goal, lab, weights);
}

TEST(ReadMissionTest, TakesWhatTheRequestNamesAndTheLabsDefaults) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  goal.planner = "";
  goal.time_limit_s = 0.0;
  goal.seed = 7;
  const sylph::Mission mission = read(goal, sylph::smallLab());
  EXPECT_EQ((std::vector<std::string>{"robot_0", "robot_1", "robot_2"}), mission.robots);
  EXPECT_EQ((sylph::Configuration{{0, 4}, {2, 0}, {0, 0}}), mission.goals);
  EXPECT_EQ("lacam", mission.planner);
  EXPECT_DOUBLE_EQ(0.2, mission.time_limit_s);
  EXPECT_EQ(7U, mission.seed);
  EXPECT_EQ(sylph::smallLab().grid, mission.grid);
}

TEST(ReadMissionTest, NamesTheWeightFileThatItCannotRead) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  goal.planner = "sylph";
  sylph::Experiment lab = sylph::smallLab();
  lab.planning.weights_path = "/nowhere.safetensors";
  const std::string failure = sylph::failureOf([&] { read(goal, lab); });
  EXPECT_EQ(0U, failure.find("1: /nowhere.safetensors: ")) << failure;
}

TEST(WeightsTest, AreReadOnceForAllPlannersThatNeedThem) {
  const std::string path = testing::TempDir() + "sylph_weights_test.safetensors";
  std::filesystem::copy_file(
      std::string(SYLPH_TEST_DATA) + "/../../../../../weights/sylph.safetensors", path,
      std::filesystem::copy_options::overwrite_existing);
  Weights weights(path);
  EXPECT_FALSE(weights.of("lacam"));
  const auto policy = weights.of("sylph");
  ASSERT_TRUE(policy);
  std::filesystem::remove(path);
  EXPECT_EQ(policy, weights.of("sylph_lacam"));
  EXPECT_THROW(Weights("").of("sylph"), std::invalid_argument);
}

TEST(ReadMissionTest, TakesSomeOfTheRobots) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  goal.robots = {"robot_2"};
  goal.goals.resize(1);
  const sylph::Mission mission = read(goal, sylph::smallLab());
  EXPECT_EQ(0U, mission.indexOf("robot_2"));
  EXPECT_EQ(1U, mission.indexOf("robot_0"));
}

struct BadRequest {
  std::string name;
  std::function<void(ExecuteMissionGoal&)> spoil;
  std::string message;  ///< a part of it
};

class BadRequestTest : public testing::TestWithParam<BadRequest> {};

TEST_P(BadRequestTest, IsRefusedWithOneClearLine) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  GetParam().spoil(goal);
  const std::string failure = sylph::failureOf([&] { read(goal, sylph::smallLab()); });
  EXPECT_EQ("1: ", failure.substr(0, 3)) << failure;
  EXPECT_NE(std::string::npos, failure.find(GetParam().message)) << failure;
  EXPECT_EQ(std::string::npos, failure.find('\n')) << failure;
}

INSTANTIATE_TEST_SUITE_P(
    Requests, BadRequestTest,
    testing::Values(
        BadRequest{"NoRobot", [](ExecuteMissionGoal& g) { g.robots.clear(); },
                   "at least one robot"},
        BadRequest{"FewerGoals", [](ExecuteMissionGoal& g) { g.goals.pop_back(); },
                   "3 robots but 2 goals"},
        BadRequest{"UnknownRobot", [](ExecuteMissionGoal& g) { g.robots[1] = "robot_9"; },
                   "unknown robot 'robot_9'; the nearest names are robot_0, robot_1"},
        BadRequest{"RobotTwice", [](ExecuteMissionGoal& g) { g.robots[1] = "robot_0"; },
                   "robot robot_0 is named twice"},
        BadRequest{"MissingMap", [](ExecuteMissionGoal& g) { g.map = "/nowhere.map"; },
                   "/nowhere.map"},
        BadRequest{
            "OtherMapSize",
            [](ExecuteMissionGoal& g) { g.map = std::string(SYLPH_TEST_DATA) + "/other_size.map"; },
            "3 x 4 cells"},
        BadRequest{"OtherCellSize", [](ExecuteMissionGoal& g) { g.cell_size_m = 0.5; },
                   "cell_size_m 0.5"},
        BadRequest{"CellSizeNotANumber", [](ExecuteMissionGoal& g) { g.cell_size_m = NAN; },
                   "cell_size_m"},
        BadRequest{"GoalOutside", [](ExecuteMissionGoal& g) { g.goals[0].row = 3; },
                   "goal (3,4) of robot_0 lies outside"},
        BadRequest{"GoalOnObstacle",
                   [](ExecuteMissionGoal& g) {
                     g.goals[1].row = 1;
                     g.goals[1].col = 2;
                   },
                   "goal (1,2) of robot_1 lies on an obstacle"},
        BadRequest{"GoalTwice", [](ExecuteMissionGoal& g) { g.goals[2] = g.goals[0]; },
                   "goal (0,4) of robot_2 is also the goal of robot_0"},
        BadRequest{"UnknownPlanner", [](ExecuteMissionGoal& g) { g.planner = "magic"; },
                   "unknown planner 'magic'"},
        BadRequest{"NoWeights", [](ExecuteMissionGoal& g) { g.planner = "sylph_lacam"; },
                   "planner 'sylph_lacam' needs the weights of a policy"},
        BadRequest{"NegativeTime", [](ExecuteMissionGoal& g) { g.time_limit_s = -1.0; },
                   "time_limit_s"}),
    [](const testing::TestParamInfo<BadRequest>& param) { return param.param.name; });

}  // namespace
}  // namespace sylph_planner_node
