#include "sylph_core/control/task_queue.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

// One row of free cells, and a pocket below (0,2).
Grid corridor() {
  return Grid::fromText(
      ".......\n"
      "##.####\n");
}

TaskOrder east(std::uint32_t plan, int sequence, int col) {
  return {plan, sequence, {0, col}, {0, col + 1}};
}

Whereabouts in(int col) {
  return {Cell{0, col}, false};
}

TEST(TaskQueueTest, TakesTasksInOrder) {
  TaskQueue queue(corridor());
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(1, 0, 0), in(0)).verdict);
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(1, 1, 1), in(0)).verdict);
  EXPECT_EQ(1U, queue.planId());
  EXPECT_EQ(2, queue.accepted());
  EXPECT_EQ(0, queue.done());
  EXPECT_EQ((std::vector<Cell>{{0, 0}, {0, 1}}), queue.heldCells());
  queue.completeCurrent();
  EXPECT_EQ((std::vector<Cell>{{0, 1}, {0, 2}}), queue.heldCells());
  queue.completeCurrent();
  EXPECT_EQ((std::vector<Cell>{{0, 2}}), queue.heldCells());
  EXPECT_TRUE(queue.isIdle());
  EXPECT_THROW(queue.completeCurrent(), std::logic_error);
}

TEST(TaskQueueTest, ARepeatedTaskChangesNothing) {
  TaskQueue queue(corridor());
  queue.offer(east(1, 0, 0), in(0));
  queue.completeCurrent();
  EXPECT_EQ(TaskVerdict::Repeated, queue.offer(east(1, 0, 0), in(1)).verdict);
  EXPECT_EQ(1, queue.accepted());
  EXPECT_EQ(1, queue.done());
}

TEST(TaskQueueTest, ATaskBehindAGapWaitsForIt) {
  TaskQueue queue(corridor());
  queue.offer(east(1, 0, 0), in(0));
  EXPECT_EQ(TaskVerdict::Early, queue.offer(east(1, 2, 2), in(0)).verdict);
  EXPECT_EQ(1, queue.accepted());
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(1, 1, 1), in(0)).verdict);
  EXPECT_EQ(3, queue.accepted());
}

TEST(TaskQueueTest, ALatePlanIsDropped) {
  TaskQueue queue(corridor());
  queue.offer(east(5, 0, 0), in(0));
  EXPECT_EQ(TaskVerdict::Late, queue.offer(east(4, 0, 0), in(0)).verdict);
  EXPECT_EQ(5U, queue.planId());
}

TEST(TaskQueueTest, ANewPlanBeginsWhenTheOldOneIsDone) {
  TaskQueue queue(corridor());
  queue.offer(east(1, 0, 0), in(0));
  EXPECT_EQ(TaskVerdict::Early, queue.offer(east(2, 0, 1), in(0)).verdict);
  queue.completeCurrent();
  EXPECT_EQ(TaskVerdict::Early, queue.offer(east(2, 1, 2), in(1)).verdict);
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(2, 0, 1), in(1)).verdict);
  EXPECT_EQ(2U, queue.planId());
  EXPECT_EQ(1, queue.accepted());
  EXPECT_EQ(0, queue.done());
}

TEST(TaskQueueTest, ANewPlanBeginsWhereTheRobotIs) {
  TaskQueue queue(corridor());
  EXPECT_EQ(TaskVerdict::Early, queue.offer(east(1, 0, 0), {}).verdict);
  const TaskAnswer answer = queue.offer(east(1, 0, 0), in(4));
  EXPECT_EQ(TaskVerdict::Refused, answer.verdict);
  EXPECT_NE(std::string::npos, answer.reason.find("(0,4)"));
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(1, 0, 0), in(0)).verdict);
}

TEST(TaskQueueTest, ADisplacedRobotMayBeginANewPlanWhereItStands) {
  TaskQueue queue(corridor());
  queue.offer(east(1, 0, 0), in(0));
  EXPECT_EQ(TaskVerdict::Refused, queue.offer(east(2, 0, 3), {Cell{0, 5}, true}).verdict);
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(2, 0, 4), {Cell{0, 4}, true}).verdict);
  EXPECT_EQ(0, queue.done());
}

TEST(TaskQueueTest, TasksToldToBeDoneAreCountedOnly) {
  TaskQueue queue(corridor());
  TaskOrder past = east(3, 0, 0);
  past.status = TaskStatus::Done;
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(past, in(2)).verdict);
  past = east(3, 1, 1);
  past.status = TaskStatus::Done;
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(past, in(2)).verdict);
  EXPECT_EQ(TaskVerdict::Accepted, queue.offer(east(3, 2, 2), in(2)).verdict);
  EXPECT_EQ(3, queue.accepted());
  EXPECT_EQ(2, queue.done());
  EXPECT_EQ((Cell{0, 2}), queue.current()->start);
}

TEST(TaskQueueTest, RefusesWhatContradictsTheMapOrWhatCameBefore) {
  TaskQueue queue(corridor());
  EXPECT_EQ(TaskVerdict::Refused, queue.offer({0, 0, {0, 0}, {0, 1}}, in(0)).verdict);
  EXPECT_EQ(TaskVerdict::Refused, queue.offer({1, 0, {0, 0}, {1, 0}}, in(0)).verdict);
  EXPECT_EQ(TaskVerdict::Refused, queue.offer({1, 0, {0, 0}, {-1, 0}}, in(0)).verdict);
  EXPECT_EQ(TaskVerdict::Refused, queue.offer({1, 0, {0, 0}, {0, 2}}, in(0)).verdict);
  EXPECT_EQ(TaskVerdict::Refused, queue.offer({1, 0, {0, 0}, {0, 0}}, in(0)).verdict);
  queue.offer(east(1, 0, 0), in(0));
  EXPECT_EQ(TaskVerdict::Refused, queue.offer(east(1, 1, 4), in(0)).verdict);  // a jump
  EXPECT_EQ(TaskVerdict::Refused, queue.offer(east(1, 0, 3), in(0)).verdict);  // was another one
  EXPECT_EQ(1, queue.accepted());
}

TEST(TaskQueueProperty, WhateverIsLostDoubledOrReorderedEachTaskIsAcceptedOnceAndInOrder) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    TaskQueue queue(corridor());
    std::vector<TaskOrder> sent;
    for (std::uint32_t round = 0; round < 40 && queue.done() < 6; ++round) {
      for (int k = 0; k < 6; ++k) {
        if (drawIndex(rng, 3) != 0) {
          sent.push_back(east(1, k, k));
        }
      }
      shuffle(sent, rng);
      while (!sent.empty() && drawIndex(rng, 4) != 0) {
        queue.offer(sent.back(), in(0));
        sent.pop_back();
        if (!queue.isIdle() && drawIndex(rng, 3) == 0) {
          queue.completeCurrent();
        }
        ASSERT_LE(queue.accepted(), 6);
        for (std::size_t i = 1; i < queue.tasks().size(); ++i) {
          ASSERT_EQ(queue.tasks()[i - 1].end, queue.tasks()[i].start);
        }
      }
    }
    EXPECT_EQ(6, queue.accepted());
  }
}

}  // namespace
}  // namespace sylph
