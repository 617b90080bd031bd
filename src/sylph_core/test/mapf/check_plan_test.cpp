#include "sylph_core/mapf/check_plan.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

Instance twoAgents(const std::string& map, Configuration starts, Configuration goals) {
  return {Grid::fromText(map), std::move(starts), std::move(goals), MotionModel{false}};
}

ViolationKind kindOf(const Instance& instance, const Plan& plan) {
  const auto violation = checkPlan(instance, plan);
  EXPECT_TRUE(violation.has_value());
  return violation ? violation->kind : ViolationKind::Empty;
}

TEST(CheckPlanTest, AcceptsFollowingInAQueue) {
  const Instance instance = twoAgents("...\n", {{0, 0}, {0, 1}}, {{0, 1}, {0, 2}});
  EXPECT_FALSE(checkPlan(instance, {{{0, 0}, {0, 1}}, {{0, 1}, {0, 2}}}).has_value());
}

TEST(CheckPlanTest, NamesEachViolation) {
  const Instance instance = twoAgents("..#\n...\n", {{0, 0}, {0, 1}}, {{1, 0}, {1, 1}});
  const Configuration start = instance.starts;
  const Configuration goal = instance.goals;
  EXPECT_EQ(ViolationKind::Empty, kindOf(instance, {}));
  EXPECT_EQ(ViolationKind::WrongAgentCount, kindOf(instance, {{{0, 0}}}));
  EXPECT_EQ(ViolationKind::WrongStart, kindOf(instance, {goal}));
  EXPECT_EQ(ViolationKind::NotFree, kindOf(instance, {start, {{0, 0}, {0, 2}}}));
  EXPECT_EQ(ViolationKind::NotFree, kindOf(instance, {start, {{-1, 0}, {0, 1}}}));
  EXPECT_EQ(ViolationKind::NotAdjacent, kindOf(instance, {start, {{1, 1}, {0, 1}}}));
  EXPECT_EQ(ViolationKind::VertexConflict, kindOf(instance, {start, {{0, 0}, {0, 0}}}));
  EXPECT_EQ(ViolationKind::EdgeConflict, kindOf(instance, {start, {{0, 1}, {0, 0}}}));
  EXPECT_EQ(ViolationKind::GoalNotReached, kindOf(instance, {start, start}));
  EXPECT_FALSE(checkPlan(instance, {start, goal}).has_value());
}

TEST(CheckPlanTest, RefusesARingOnlyWithoutRotations) {
  const Configuration start = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const Configuration goal = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  Instance instance{Grid(2, 2), start, goal, MotionModel{false}};
  const auto violation = checkPlan(instance, {start, goal});
  ASSERT_TRUE(violation.has_value());
  EXPECT_EQ(ViolationKind::Rotation, violation->kind);
  EXPECT_EQ((std::vector<AgentId>{0, 1, 2, 3}), violation->agents);
  instance.motion.rotations = true;
  EXPECT_FALSE(checkPlan(instance, {start, goal}).has_value());
}

TEST(FindRotationsTest, FindsARingBehindATail) {
  // Agent 0 wants into the rotation of 1, 2, 3, 4 and is no part of it.
  const Configuration from = {{0, 0}, {0, 1}, {0, 2}, {1, 2}, {1, 1}};
  const Configuration to = {{0, 1}, {0, 2}, {1, 2}, {1, 1}, {0, 1}};
  const auto rotations = findRotations(from, to);
  ASSERT_EQ(1U, rotations.size());
  EXPECT_EQ((std::vector<AgentId>{1, 2, 3, 4}), rotations.front());
}

}  // namespace
}  // namespace sylph
