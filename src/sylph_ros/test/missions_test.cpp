#include "sylph_ros/missions.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/ExecuteMissionResult.h>

namespace sylph_ros {
namespace {

using sylph_msgs::ExecuteMissionResult;

TEST(ToGoalTest, AsksForAllRobotsOfTheExperiment) {
  sylph::Experiment experiment;
  experiment.map_path = "/lab/small.map";
  experiment.cell_size_m = 0.25;
  experiment.seed = 7;
  experiment.planning.planner = "pibt";
  experiment.planning.time_limit_s = 1.5;
  experiment.robots.resize(2);
  experiment.robots[0].name = "alpha";
  experiment.robots[1].name = "beta";
  experiment.robots[1].goal = {2, 3};

  const auto goal = toGoal(experiment);
  EXPECT_EQ((std::vector<std::string>{"alpha", "beta"}), goal.robots);
  ASSERT_EQ(2U, goal.goals.size());
  EXPECT_EQ(2, goal.goals[1].row);
  EXPECT_EQ(3, goal.goals[1].col);
  EXPECT_EQ("/lab/small.map", goal.map);
  EXPECT_DOUBLE_EQ(0.25, goal.cell_size_m);
  EXPECT_EQ("pibt", goal.planner);
  EXPECT_DOUBLE_EQ(1.5, goal.time_limit_s);
  EXPECT_EQ(7U, goal.seed);
}

TEST(OutcomeNameTest, NamesEachOutcome) {
  EXPECT_EQ("SUCCESS", outcomeName(ExecuteMissionResult::SUCCESS));
  EXPECT_EQ("INCOMPLETE", outcomeName(ExecuteMissionResult::INCOMPLETE));
  EXPECT_EQ("outcome 99", outcomeName(99));
}

}  // namespace
}  // namespace sylph_ros
