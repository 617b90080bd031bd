#include "sylph_planner_node/plan_server.hpp"

#include <gtest/gtest.h>
#include <ros/topic.h>

#include <string>

#include "planner_fixture.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/plan_messages.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::ExecuteMissionGoal;
using sylph_msgs::ExecuteMissionResult;
using sylph_ros::toGoal;

class PlanServerTest : public PlannerFixture {
 protected:
  void SetUp() override {
    PlannerFixture::SetUp();
    ASSERT_TRUE(waitUntil([this] { return plans_.isServerConnected(); }));
  }

  ExecuteMissionResult plan(const ExecuteMissionGoal& goal) {
    plans_.sendGoal(goal);
    EXPECT_TRUE(waitUntil([this] { return plans_.getState().isDone(); }));
    const auto result = plans_.getResult();
    return result ? *result : ExecuteMissionResult();
  }

  static sylph_msgs::JointActions shown() {
    const auto plan = ros::topic::waitForMessage<sylph_msgs::JointActions>("/sylph/shown_plan",
                                                                           ros::Duration(20.0));
    return plan ? *plan : sylph_msgs::JointActions();
  }

  Client plans_{"/sylph/plan_mission", true};
};

TEST_F(PlanServerTest, ShowsAPlanAndMovesNothing) {
  const ExecuteMissionResult result = plan(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  EXPECT_NE(std::string::npos, result.message.find(" steps, sum of costs ")) << result.message;
  const sylph_msgs::JointActions plan = shown();
  EXPECT_EQ(result.shown_plan_id, plan.plan_id);
  EXPECT_EQ(result.plan_steps, plan.steps.size());
  EXPECT_EQ(3U, plan.agents.size());
  ASSERT_TRUE(central_.waitForStatesOnTheirWay());
  EXPECT_TRUE(central_.received().empty());
}

TEST_F(PlanServerTest, WhatWasShownIsCarriedOut) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  goal.shown_plan_id = plan(goal).shown_plan_id;
  const sylph_msgs::JointActions plan = shown();
  const ExecuteMissionResult result = run(goal);
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome) << result.message;
  ASSERT_FALSE(central_.received().empty());
  EXPECT_EQ(sylph_ros::fromMessage(plan).plan, central_.plan());
  EXPECT_EQ(0U, shown().plan_id) << "a plan is still shown that has become a mission";
}

TEST_F(PlanServerTest, RefusesToCarryOutWhatIsNotShown) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  const std::uint32_t number = plan(goal).shown_plan_id;
  goal.shown_plan_id = number + 1;
  EXPECT_EQ("plan " + std::to_string(number + 1) + " is not shown any more: plan again",
            run(goal).message);
  goal.shown_plan_id = number;
  goal.goals[1].row = 1;
  EXPECT_EQ("plan " + std::to_string(number) + " is of other robots, goals or map: plan again",
            run(goal).message);
  EXPECT_TRUE(central_.received().empty());
}

TEST_F(PlanServerTest, TellsWhyThereIsNoPlan) {
  ExecuteMissionGoal goal = toGoal(sylph::smallLab());
  goal.goals[2] = goal.goals[0];
  const ExecuteMissionResult result = plan(goal);
  EXPECT_EQ(ExecuteMissionResult::BAD_REQUEST, result.outcome);
  EXPECT_EQ("goal (0,4) of robot_2 is also the goal of robot_0", result.message);
  EXPECT_EQ(0U, result.shown_plan_id);
}

TEST_F(PlanServerTest, WaitsForPosesOnlySoLong) {
  central_.silencePoseOf("robot_1");
  const ExecuteMissionResult result = plan(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::NO_POSE, result.outcome);
  EXPECT_NE(std::string::npos, result.message.find("robot_1")) << result.message;
}

TEST_F(PlanServerTest, LeavesAMissionThatIsUnderWayAlone) {
  central_.haltAfter(1);
  client_.sendGoal(toGoal(sylph::smallLab()));
  ASSERT_TRUE(waitForPhase(AdgState::EXECUTING));
  const ExecuteMissionResult result = plan(toGoal(sylph::smallLab()));
  EXPECT_EQ(ExecuteMissionResult::BAD_REQUEST, result.outcome);
  EXPECT_EQ("a mission is under way: plan when it has ended, or cancel it", result.message);
  EXPECT_EQ(AdgState::RUN, central_.state().mode);
  central_.haltAfter(1000);
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, waitForResult().outcome);
}

}  // namespace
}  // namespace sylph_planner_node
