#include "sylph_planner_node/joint_actions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sylph_ros/conversions.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AgentAction;
using sylph_msgs::JointAction;

/// Two agents on one row; the first goes east twice, the second leaves the row and stays.
CheckedPlan smallPlan() {
  CheckedPlan plan;
  plan.plan = {{{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{1, 2}, {0, 1}}};
  plan.instance.grid = sylph::Grid(2, 3);
  plan.instance.starts = plan.plan.front();
  plan.instance.goals = plan.plan.back();
  const float unknown = std::nanf("");
  plan.social = {{{1, 1}, {45.0F, unknown}}, {{0, 1}, {5.0F, unknown}}};
  plan.planning_s = 0.25;
  return plan;
}

TEST(ToJointActionsTest, SaysWhoDoesWhatInEachStep) {
  const std::vector<JointAction> messages =
      toJointActions(smallPlan(), {"robot_4", "robot_2"}, {9, 8, "lacam"});
  ASSERT_EQ(2U, messages.size());
  for (std::size_t step = 0; step < messages.size(); ++step) {
    EXPECT_EQ(9U, messages[step].plan_id);
    EXPECT_EQ(8U, messages[step].replaces_plan_id);
    EXPECT_EQ(step, messages[step].step);
    EXPECT_EQ(2U, messages[step].steps);
    EXPECT_EQ("lacam", messages[step].planner);
    EXPECT_EQ("map", messages[step].header.frame_id);
    EXPECT_DOUBLE_EQ(0.25, messages[step].planning_s);
    ASSERT_EQ(2U, messages[step].agents.size());
    EXPECT_EQ("robot_4", messages[step].agents[0].robot);
    EXPECT_EQ("robot_2", messages[step].agents[1].robot);
    EXPECT_EQ((sylph::Cell{1, 2}), sylph_ros::fromMessage(messages[step].agents[0].goal));
  }
  const AgentAction& first = messages[0].agents[1];
  EXPECT_EQ(AgentAction::NORTH, first.action);
  EXPECT_EQ((sylph::Cell{1, 1}), sylph_ros::fromMessage(first.from));
  EXPECT_EQ((sylph::Cell{0, 1}), sylph_ros::fromMessage(first.to));
  EXPECT_EQ(AgentAction::EAST, messages[1].agents[0].action);
  EXPECT_EQ(AgentAction::STAY, messages[1].agents[1].action);
}

TEST(ToJointActionsTest, NamesPartnersAndLeavesThemOutWhereThereIsNone) {
  const auto messages = toJointActions(smallPlan(), {"robot_4", "robot_2"}, {1, 0, "lacam"});
  EXPECT_EQ("robot_2", messages[0].agents[0].partner);
  EXPECT_FLOAT_EQ(45.0F, messages[0].agents[0].svo_deg);
  EXPECT_EQ("", messages[0].agents[1].partner);
  EXPECT_TRUE(std::isnan(messages[0].agents[1].svo_deg));
  EXPECT_EQ("", messages[1].agents[0].partner);
}

TEST(ToJointActionsTest, APlanInWhichNobodyMovesIsOneMessage) {
  CheckedPlan plan = smallPlan();
  plan.plan.resize(1);
  plan.social.clear();
  const auto messages = toJointActions(plan, {"robot_0", "robot_1"}, {1, 0, "lacam"});
  ASSERT_EQ(1U, messages.size());
  EXPECT_EQ(0U, messages[0].steps);
  for (const AgentAction& agent : messages[0].agents) {
    EXPECT_EQ(AgentAction::STAY, agent.action);
    EXPECT_EQ(sylph_ros::fromMessage(agent.from), sylph_ros::fromMessage(agent.to));
    EXPECT_TRUE(std::isnan(agent.svo_deg));
  }
}

}  // namespace
}  // namespace sylph_planner_node
