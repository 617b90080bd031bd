#include "sylph_adg_central/plan_assembler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sylph_ros/conversions.hpp"

namespace sylph_adg_central {
namespace {

using sylph_msgs::AgentAction;
using sylph_msgs::JointAction;

AgentAction moveEast(const std::string& robot, int row, int col) {
  AgentAction action;
  action.robot = robot;
  action.action = AgentAction::EAST;
  action.from = sylph_ros::toMessage(sylph::Cell{row, col});
  action.to = sylph_ros::toMessage(sylph::Cell{row, col + 1});
  action.goal = sylph_ros::toMessage(sylph::Cell{row, 9});
  action.svo_deg = std::numeric_limits<float>::quiet_NaN();
  return action;
}

JointAction message(std::uint32_t plan_id, std::uint32_t step, std::uint32_t steps) {
  JointAction action;
  action.plan_id = plan_id;
  action.step = step;
  action.steps = steps;
  action.planner = "test";
  action.agents = {moveEast("robot_0", 0, static_cast<int>(step)),
                   moveEast("robot_1", 1, static_cast<int>(step))};
  action.agents[1].partner = "robot_0";
  return action;
}

std::string refusalOf(PlanAssembler& assembler, const JointAction& bad) {
  try {
    assembler.add(bad);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "the message was accepted";
  return {};
}

TEST(PlanAssemblerTest, PutsAPlanTogetherInAnyOrder) {
  PlanAssembler assembler;
  EXPECT_FALSE(assembler.add(message(3, 2, 3)));
  EXPECT_FALSE(assembler.add(message(3, 2, 3))) << "it came twice";
  EXPECT_FALSE(assembler.add(message(2, 0, 3))) << "an older plan";
  EXPECT_FALSE(assembler.add(message(3, 0, 3)));
  EXPECT_EQ(2u, assembler.stepsReceived());
  const auto plan = assembler.add(message(3, 1, 3));
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(3u, plan->plan_id);
  EXPECT_EQ((std::vector<std::string>{"robot_0", "robot_1"}), plan->robots);
  EXPECT_EQ((sylph::Plan{{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 2}, {1, 2}}, {{0, 3}, {1, 3}}}),
            plan->plan);
  EXPECT_EQ((sylph::Configuration{{0, 9}, {1, 9}}), plan->goals);
  ASSERT_EQ(3u, plan->social.size());
  EXPECT_EQ((std::vector<sylph::AgentId>{0, 0}), plan->social[1].partners);
  EXPECT_TRUE(std::isnan(plan->social[1].svo_deg[0]));
  EXPECT_FALSE(assembler.add(message(3, 1, 3))) << "it was complete before";
}

TEST(PlanAssemblerTest, APlanWithoutMovesIsOneMessage) {
  PlanAssembler assembler;
  JointAction rest = message(1, 0, 0);
  for (AgentAction& agent : rest.agents) {
    agent.action = AgentAction::STAY;
    agent.to = agent.from;
  }
  const auto plan = assembler.add(rest);
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ((sylph::Plan{{{0, 0}, {1, 0}}}), plan->plan);
  EXPECT_TRUE(plan->social.empty());
}

TEST(PlanAssemblerTest, ANewerPlanTakesThePlaceOfAnUnfinishedOne) {
  PlanAssembler assembler;
  assembler.add(message(1, 0, 2));
  assembler.add(message(2, 0, 2));
  EXPECT_FALSE(assembler.add(message(1, 1, 2)));
  EXPECT_TRUE(assembler.add(message(2, 1, 2)));
}

TEST(PlanAssemblerTest, RefusesWhatIsMalformed) {
  PlanAssembler assembler;
  EXPECT_EQ("step 3: the plan has only 3 steps", refusalOf(assembler, message(1, 3, 3)));
  EXPECT_EQ("step 0: 4000000000 steps are more than 1000000",
            refusalOf(assembler, message(2, 0, 4000000000U)));
  JointAction bad = message(3, 0, 2);
  bad.agents.clear();
  EXPECT_EQ("step 0: it names no robots", refusalOf(assembler, bad));
  bad = message(4, 0, 2);
  bad.agents[1].action = 17;
  EXPECT_EQ("step 0: action 17 of robot_1 does not lead from (1,0) to (1,1)",
            refusalOf(assembler, bad));
  bad = message(5, 0, 2);
  bad.agents[0].to.row = 3;
  EXPECT_EQ("step 0: action 2 of robot_0 does not lead from (0,0) to (3,1)",
            refusalOf(assembler, bad));
}

TEST(PlanAssemblerTest, RefusesMessagesThatContradictEachOther) {
  PlanAssembler assembler;
  assembler.add(message(1, 0, 3));
  EXPECT_EQ("step 1: 2 steps, but 3 in another message of the plan",
            refusalOf(assembler, message(1, 1, 2)));
  EXPECT_FALSE(assembler.add(message(1, 1, 3))) << "the plan was given up";
  assembler.add(message(2, 1, 3));
  JointAction bad = message(2, 0, 3);
  bad.agents[1] = moveEast("robot_1", 1, 4);
  EXPECT_EQ("step 0: robot_1 does not go on where it is in step 1", refusalOf(assembler, bad));
  assembler.add(message(3, 1, 3));
  bad = message(3, 2, 3);
  bad.agents.pop_back();
  EXPECT_EQ("step 2: robots or replaces_plan_id differ from step 1", refusalOf(assembler, bad));
}

}  // namespace
}  // namespace sylph_adg_central
