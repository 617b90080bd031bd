#include "sylph_ros/missions.hpp"

#include <actionlib_msgs/GoalStatus.h>
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

TEST(IsUnderWayTest, LooksForAGoalThatHasNotEnded) {
  actionlib_msgs::GoalStatusArray status;
  EXPECT_FALSE(isUnderWay(status));
  status.status_list.resize(2);
  status.status_list[0].status = actionlib_msgs::GoalStatus::SUCCEEDED;
  status.status_list[1].status = actionlib_msgs::GoalStatus::ABORTED;
  EXPECT_FALSE(isUnderWay(status));
  for (const std::uint8_t state :
       {actionlib_msgs::GoalStatus::PENDING, actionlib_msgs::GoalStatus::ACTIVE,
        actionlib_msgs::GoalStatus::PREEMPTING}) {
    status.status_list[1].status = state;
    EXPECT_TRUE(isUnderWay(status)) << int(state);
  }
}

TEST(OutcomeNameTest, NamesEachOutcome) {
  EXPECT_EQ("SUCCESS", outcomeName(ExecuteMissionResult::SUCCESS));
  EXPECT_EQ("INCOMPLETE", outcomeName(ExecuteMissionResult::INCOMPLETE));
  EXPECT_EQ("outcome 99", outcomeName(99));
}

}  // namespace
}  // namespace sylph_ros
