#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <ros/topic.h>
#include <sylph_msgs/JointActions.h>

#include <algorithm>
#include <atomic>

#include "planner_fixture.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::ExecuteMissionGoal;
using sylph_msgs::ExecuteMissionResult;
using sylph_ros::toGoal;

class PlannerNodeTest : public PlannerFixture {};

TEST_F(PlannerNodeTest, PublishesTheMapForThoseWhoComeLate) {
  const auto map = ros::topic::waitForMessage<nav_msgs::OccupancyGrid>("/map", ros::Duration(20.0));
  ASSERT_TRUE(map);
  EXPECT_EQ("map", map->header.frame_id);
  EXPECT_FLOAT_EQ(0.3F, map->info.resolution);
  EXPECT_EQ(5U, map->info.width);
  EXPECT_EQ(15U, map->data.size());
  EXPECT_EQ(100, map->data[6]);
}

TEST_F(PlannerNodeTest, CarriesAMissionOut) {
  const ExecuteMissionResult result = run(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  EXPECT_EQ(actionlib::SimpleClientGoalState::SUCCEEDED, client_.getState().state_);
  EXPECT_EQ(3U, result.robots);
  EXPECT_EQ(3U, result.arrived);
  EXPECT_GT(result.planning_s, 0.0);
  const sylph::Plan plan = central_.plan();
  EXPECT_EQ(result.plan_steps, plan.size() - 1);
  const sylph::Instance instance = {
      sylph::smallMission().grid, sylph::smallStarts(), sylph::smallMission().goals, {}};
  EXPECT_FALSE(sylph::checkPlan(instance, plan));
  EXPECT_EQ(0U, central_.received().front().replaces_plan_id);
}

TEST_F(PlannerNodeTest, StartsWhereTheRobotsAreNotWhereTheFileSays) {
  MockCentral& central = central_;
  run(toGoal(sylph::smallLab()));
  ExecuteMissionGoal back = toGoal(sylph::smallLab());
  for (std::size_t i = 0; i < back.goals.size(); ++i) {
    back.goals[i] = sylph_ros::toMessage(sylph::smallStarts()[i]);
  }
  const ExecuteMissionResult result = run(back);
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  EXPECT_EQ(sylph::smallMission().goals, central.plan().front());
  EXPECT_EQ(sylph::smallStarts(), central.plan().back());
}

TEST_F(PlannerNodeTest, SendsAgainWhatDidNotArrive) {
  central_.dropOnePlan();
  const ExecuteMissionResult result = run(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  const auto received = central_.received();
  ASSERT_EQ(2U, received.size());
  EXPECT_EQ(received.front().plan_id, received.back().plan_id);
}

TEST_F(PlannerNodeTest, TakesThePlanBackWhenTheMissionIsOver) {
  run(toGoal(sylph::smallLab()));
  ASSERT_TRUE(waitUntil([] {
    const auto late = ros::topic::waitForMessage<sylph_msgs::JointActions>(
        "/sylph/" + std::string(sylph_ros::kJointActionsTopic), ros::Duration(5.0));
    return late && late->plan_id == 0;
  }));
}

TEST_F(PlannerNodeTest, NumbersPlansAfterThoseTheCentralNodeKnows) {
  central_.setPlanId(4100);
  ASSERT_TRUE(waitUntil([&] {
    run(toGoal(sylph::smallLab()));
    return central_.state().plan_id > 4100;
  }));
}

TEST_F(PlannerNodeTest, RefusesABadRequestBeforeAnythingIsSent) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  goal.robots[2] = "robot_9";
  const ExecuteMissionResult result = run(goal);
  EXPECT_EQ(ExecuteMissionResult::BAD_REQUEST, result.outcome);
  EXPECT_NE(std::string::npos, result.message.find("robot_9")) << result.message;
  EXPECT_EQ(actionlib::SimpleClientGoalState::ABORTED, client_.getState().state_);
  EXPECT_TRUE(central_.received().empty());
}

TEST_F(PlannerNodeTest, NamesTheRobotWhosePoseIsMissing) {
  central_.silencePoseOf("robot_1");
  const ExecuteMissionResult result = run(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::NO_POSE, result.outcome);
  EXPECT_NE(std::string::npos, result.message.find("robot_1")) << result.message;
  EXPECT_TRUE(central_.received().empty());
}

TEST_F(PlannerNodeTest, PassesOnWhyThePlanWasRefused) {
  central_.refusePlans("no safety margin");
  const ExecuteMissionResult result = run(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::PLAN_REFUSED, result.outcome);
  EXPECT_NE(std::string::npos, result.message.find("no safety margin")) << result.message;
}

TEST_F(PlannerNodeTest, GivesUpWithoutCentralNode) {
  central_.beSilent();
  const ExecuteMissionResult result = run(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::PLAN_REFUSED, result.outcome);
  EXPECT_NE(std::string::npos, result.message.find("silent")) << result.message;
}

TEST_F(PlannerNodeTest, PausesWhenCancelledAndResumesWithTheNextMission) {
  central_.haltAfter(1);
  client_.sendGoal(toGoal(sylph::smallLab()));
  ASSERT_TRUE(waitForPhase(AdgState::EXECUTING));
  client_.cancelGoal();
  const ExecuteMissionResult cancelled = waitForResult();
  EXPECT_EQ(ExecuteMissionResult::PREEMPTED, cancelled.outcome) << cancelled.message;
  EXPECT_EQ(actionlib::SimpleClientGoalState::PREEMPTED, client_.getState().state_);
  EXPECT_EQ(AdgState::PAUSE, central_.state().mode);

  central_.haltAfter(1000);
  ExecuteMissionGoal other = toGoal(sylph::smallLab());
  other.goals[1].row = 1;
  const ExecuteMissionResult result = run(other);
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  EXPECT_EQ(AdgState::RUN, central_.state().mode);
}

TEST_F(PlannerNodeTest, ANewMissionTakesThePlaceOfTheOldOne) {
  central_.haltAfter(1);
  Client first("/sylph/execute_mission", true);
  ASSERT_TRUE(waitUntil([&] { return first.isServerConnected(); }));
  first.sendGoal(toGoal(sylph::smallLab()));
  ASSERT_TRUE(waitForPhase(AdgState::EXECUTING));
  ExecuteMissionGoal other = toGoal(sylph::smallLab());
  other.goals[1].row = 1;
  client_.sendGoal(other);
  ASSERT_TRUE(waitUntil([this] { return central_.state().mode == AdgState::PAUSE; }));
  central_.haltAfter(1000);
  const ExecuteMissionResult result = waitForResult();
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  ASSERT_TRUE(waitUntil([&] { return first.getState().isDone(); }));
  EXPECT_EQ(ExecuteMissionResult::PREEMPTED, first.getResult()->outcome);
}

TEST_F(PlannerNodeTest, PlansTheRestAroundALostRobot) {
  central_.haltAfter(1);
  client_.sendGoal(toGoal(sylph::smallLab()));
  ASSERT_TRUE(waitUntil([this] {
    return central_.state().phase == AdgState::EXECUTING &&
           central_.state().robots[0].tasks_done == 1;
  }));
  const std::uint32_t first_id = central_.state().plan_id;
  central_.lose("robot_1");
  central_.haltAfter(1000);
  const ExecuteMissionResult result = waitForResult();
  EXPECT_EQ(ExecuteMissionResult::INCOMPLETE, result.outcome);
  EXPECT_EQ(2U, result.arrived) << result.message;
  EXPECT_EQ(1U, result.replans);
  EXPECT_NE(std::string::npos, result.message.find("robot_1 is lost")) << result.message;
  const sylph_msgs::JointActions last = central_.received().back();
  EXPECT_EQ(first_id + 1, last.plan_id);
  EXPECT_EQ(first_id, last.replaces_plan_id);
  EXPECT_EQ(2U, last.agents.size());
  const sylph::Cell lost = sylph_ros::fromMessage(central_.state().robots[1].cell);
  for (const sylph::Configuration& configuration : central_.plan()) {
    EXPECT_EQ(0, std::count(configuration.begin(), configuration.end(), lost));
  }
}

TEST_F(PlannerNodeTest, GoesOnWithItsMissionAfterARestart) {
  central_.pretendToExecute(9000, sylph::smallMission().goals);
  ASSERT_TRUE(central_.waitForStatesOnTheirWay());
  std::atomic<bool> follows{false};
  client_.sendGoal(toGoal(sylph::smallLab()), Client::SimpleDoneCallback(),
                   Client::SimpleActiveCallback(),
                   [&follows](const sylph_msgs::ExecuteMissionFeedbackConstPtr& feedback) {
                     follows = feedback->phase == "executing";
                   });
  ASSERT_TRUE(waitUntil([&follows] { return follows.load(); }));
  central_.finish();
  const ExecuteMissionResult result = waitForResult();
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  EXPECT_TRUE(central_.received().empty());
}

TEST_F(PlannerNodeTest, RefusesAMissionWhileAnotherPlanIsCarriedOut) {
  central_.pretendToExecute(9500, sylph::smallStarts());
  ASSERT_TRUE(central_.waitForStatesOnTheirWay());
  const ExecuteMissionResult result = run(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::BAD_REQUEST, result.outcome);
  EXPECT_NE(std::string::npos, result.message.find("plan 9500")) << result.message;
}

}  // namespace
}  // namespace sylph_planner_node

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "planner_node_test");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
