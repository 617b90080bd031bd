#include "sylph_planner_node/mission_text.hpp"

#include <gtest/gtest.h>

namespace sylph_planner_node {
namespace {

using sylph_msgs::ExecuteMissionResult;

TEST(ProgressTextTest, CountsAndNamesWhoWaits) {
  sylph_msgs::ExecuteMissionFeedback feedback;
  feedback.phase = "planning";
  EXPECT_EQ("planning", progressText(feedback, 8));
  feedback.phase = "executing";
  feedback.tasks_done = 31;
  feedback.tasks_total = 120;
  feedback.robots_arrived = 2;
  feedback.waiting = {"robot_1 waits"};
  EXPECT_EQ("executing: 31 of 120 tasks, 2 of 8 robots arrived\n    robot_1 waits",
            progressText(feedback, 8));
}

TEST(ResultTextTest, BeginsWithTheOutcome) {
  ExecuteMissionResult result;
  result.outcome = ExecuteMissionResult::NO_POSE;
  result.message = "no pose of robot_1 has come";
  EXPECT_EQ(0U, resultText(result).find("NO_POSE: no pose of robot_1 has come\n"));
}

}  // namespace
}  // namespace sylph_planner_node
