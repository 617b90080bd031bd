#include "sylph_ros/plan_messages.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/AgentAction.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "sylph_ros/conversions.hpp"

namespace sylph_ros {
namespace {

using sylph_msgs::AgentAction;
using sylph_msgs::JointActions;

/// Two agents; the first goes east twice, the second north and then stays.
sylph::MissionPlan smallPlan() {
  sylph::MissionPlan plan;
  plan.plan_id = 9;
  plan.replaces_plan_id = 8;
  plan.planner = "lacam";
  plan.planning_s = 0.25;
  plan.robots = {"robot_4", "alpha"};
  plan.goals = {{1, 5}, {0, 1}};
  plan.plan = {{{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{1, 2}, {0, 1}}};
  plan.social = {{{1, 1}, {45.0F, std::nanf("")}}, {{0, 1}, {5.0F, std::nanf("")}}};
  return plan;
}

std::string refusalOf(const JointActions& message) {
  try {
    fromMessage(message);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "the message was accepted";
  return {};
}

TEST(PlanMessagesTest, APlanThereAndBackIsTheIdentity) {
  const sylph::MissionPlan plan = smallPlan();
  const sylph::MissionPlan back = fromMessage(toMessage(plan));
  EXPECT_EQ(9U, back.plan_id);
  EXPECT_EQ(8U, back.replaces_plan_id);
  EXPECT_EQ(0U, back.first_step);
  EXPECT_EQ("lacam", back.planner);
  EXPECT_EQ(0.25, back.planning_s);
  EXPECT_EQ(plan.robots, back.robots);
  EXPECT_EQ(plan.goals, back.goals);
  EXPECT_EQ(plan.plan, back.plan);
  ASSERT_EQ(2U, back.social.size());
  for (std::size_t step = 0; step < 2; ++step) {
    EXPECT_EQ(plan.social[step].partners, back.social[step].partners);
    EXPECT_EQ(plan.social[step].svo_deg[0], back.social[step].svo_deg[0]);
    EXPECT_TRUE(std::isnan(back.social[step].svo_deg[1]));
  }
}

TEST(PlanMessagesTest, AMessageTellsTheReaderWhoDoesWhat) {
  const JointActions message = toMessage(smallPlan());
  EXPECT_EQ("map", message.header.frame_id);
  ASSERT_EQ(2U, message.steps.size());
  const AgentAction& second = message.steps[0].actions[1];
  EXPECT_EQ(AgentAction::NORTH, second.action);
  EXPECT_EQ((sylph::Cell{1, 1}), fromMessage(second.from));
  EXPECT_EQ((sylph::Cell{0, 1}), fromMessage(second.to));
  EXPECT_EQ("", second.partner);
  EXPECT_EQ("alpha", message.steps[0].actions[0].partner);
  EXPECT_EQ(AgentAction::STAY, message.steps[1].actions[1].action);
}

TEST(PlanMessagesTest, APlanInWhichNobodyMovesHasNoSteps) {
  sylph::MissionPlan plan = smallPlan();
  plan.plan.resize(1);
  plan.social.clear();
  EXPECT_TRUE(toMessage(plan).steps.empty());
  EXPECT_EQ(plan.plan, fromMessage(toMessage(plan)).plan);
}

TEST(PlanMessagesTest, RefusesWhatIsMalformedByStepAndAgent) {
  JointActions message = toMessage(smallPlan());
  message.agents.clear();
  EXPECT_EQ("it names no agents", refusalOf(message));
  message = toMessage(smallPlan());
  message.goals.pop_back();
  EXPECT_EQ("goals: 1, but there are 2 agents", refusalOf(message));
  message = toMessage(smallPlan());
  message.starts.emplace_back();
  EXPECT_EQ("starts: 3, but there are 2 agents", refusalOf(message));
  message = toMessage(smallPlan());
  message.steps[1].actions.pop_back();
  EXPECT_EQ("step 1: actions: 1, but there are 2 agents", refusalOf(message));
  message = toMessage(smallPlan());
  message.steps[0].actions[1].action = 17;
  EXPECT_EQ("step 0: action 17 of alpha does not lead from (1,1) to (0,1)", refusalOf(message));
  message = toMessage(smallPlan());
  message.steps[0].actions[0].to.row = 3;
  EXPECT_EQ("step 0: action 2 of robot_4 does not lead from (1,0) to (3,1)", refusalOf(message));
  message = toMessage(smallPlan());
  message.steps[1].actions[0].from.col = 4;
  message.steps[1].actions[0].to.col = 5;
  EXPECT_EQ("step 1: robot_4 goes on from (1,4), but it is in (1,1)", refusalOf(message));
}

TEST(PlanMessagesTest, RefusesWhatDoesNotFitIntoAMessageAtBothEnds) {
  const std::string line =
      "it has 2000001 steps of 2 agents: a message holds at most 4000000 actions";
  JointActions message = toMessage(smallPlan());
  message.steps.resize(2000001);
  EXPECT_EQ(line, refusalOf(message));
  sylph::MissionPlan plan = smallPlan();
  plan.plan.resize(2000002);
  try {
    toMessage(plan);
    FAIL() << "the plan was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(line, error.what());
  }
}

}  // namespace
}  // namespace sylph_ros
