#include "sylph_planner_node/plan_sender.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::JointAction;

std::vector<JointAction> messagesOf(std::uint32_t steps) {
  std::vector<JointAction> messages(steps);
  for (std::uint32_t step = 0; step < steps; ++step) {
    messages[step].plan_id = 3;
    messages[step].step = step;
    messages[step].steps = steps;
  }
  return messages;
}

TEST(PlanSenderTest, SendsAllInBatchesAndAllAgainAfterAWhile) {
  const auto steps = static_cast<std::uint32_t>(PlanSender::kBatch) + 20;
  PlanSender sender(messagesOf(steps), 0.5);
  EXPECT_EQ(PlanSender::kBatch, sender.due(10.0).size());
  const auto second = sender.due(10.1);
  ASSERT_EQ(20U, second.size());
  EXPECT_EQ(PlanSender::kBatch, second.front().step);
  EXPECT_TRUE(sender.due(10.5).empty());
  const auto again = sender.due(10.7);
  ASSERT_EQ(PlanSender::kBatch, again.size());
  EXPECT_EQ(0U, again.front().step);
}

TEST(PlanSenderTest, HasArrivedWhenTheCentralNodeHasEachStepOfThisPlan) {
  const PlanSender sender(messagesOf(4), 0.5);
  AdgState state;
  state.plan_id = 3;
  state.phase = AdgState::RECEIVING;
  state.steps_received = 3;
  EXPECT_FALSE(sender.hasArrived(state));
  state.phase = AdgState::EXECUTING;
  state.steps_received = 4;
  EXPECT_TRUE(sender.hasArrived(state));
  state.plan_id = 2;
  EXPECT_FALSE(sender.hasArrived(state));
}

TEST(PlanSenderTest, RefusesAnEmptyPlan) {
  EXPECT_THROW(PlanSender({}, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_planner_node
