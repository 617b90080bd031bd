#include "sylph_planner_node/progress.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/TaskReport.h>

#include "small_lab.hpp"
#include "sylph_ros/conversions.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::ExecuteMissionResult;
using sylph_msgs::RobotExecution;

/// All robots of the small mission on their goals.
AdgState finishedState() {
  const Mission mission = smallMission();
  AdgState state;
  state.plan_id = 1;
  state.phase = AdgState::FINISHED;
  state.elapsed_s = 12.5;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    RobotExecution robot;
    robot.robot_id = mission.robots[i];
    robot.cell = sylph_ros::toMessage(mission.goals[i]);
    robot.goal = robot.cell;
    robot.tasks_total = 4;
    robot.tasks_done = 4;
    state.robots.push_back(robot);
  }
  return state;
}

TEST(WaitingLinesTest, SayWhoWaitsForWhomAndWhy) {
  AdgState state = finishedState();
  RobotExecution& robot = state.robots[0];
  robot.waiting = true;
  robot.waited_s = 1.23;
  robot.waits_for_robot = "robot_1";
  robot.waits_for_cell = sylph_ros::toMessage(sylph::Cell{2, 3});
  robot.root_cause_robot = "robot_2";
  robot.root_cause = "has no good pose";
  state.robots[2].condition = RobotExecution::BLIND;
  const std::vector<std::string> lines = waitingLines(state);
  ASSERT_EQ(2U, lines.size());
  EXPECT_EQ("robot_0 waits 1.2 s for robot_1 to leave (2,3); held up by robot_2: has no good pose",
            lines[0]);
  EXPECT_EQ("robot_2 has no good pose", lines[1]);
}

TEST(WaitingLinesTest, BeginWithAPause) {
  AdgState state = finishedState();
  EXPECT_TRUE(waitingLines(state).empty());
  state.mode = AdgState::PAUSE;
  state.message = "operator";
  EXPECT_EQ("paused: operator; /sylph/resume goes on", waitingLines(state).front());
}

TEST(FeedbackTest, CountsTasksAndArrivals) {
  AdgState state = finishedState();
  state.robots[1].tasks_done = 1;
  const auto feedback = toFeedback("executing", smallMission(), state);
  EXPECT_EQ("executing", feedback.phase);
  EXPECT_EQ(9U, feedback.tasks_done);
  EXPECT_EQ(12U, feedback.tasks_total);
  EXPECT_EQ(2U, feedback.robots_arrived);
}

TEST(FinishedResultTest, IsSuccessOnlyIfAllAreOnTheirGoals) {
  const auto result = finishedResult(smallMission(), finishedState(), {});
  EXPECT_EQ(ExecuteMissionResult::SUCCESS, result.outcome);
  EXPECT_EQ(3U, result.arrived);
  EXPECT_EQ(3U, result.robots);
  EXPECT_DOUBLE_EQ(12.5, result.execution_s);
}

TEST(FinishedResultTest, SaysWhoDidNotArriveAndWhy) {
  AdgState state = finishedState();
  state.robots[1].condition = RobotExecution::LOST;
  state.robots[0].cell = sylph_ros::toMessage(sylph::Cell{0, 3});
  const auto result =
      finishedResult(smallMission(), state, {"robot_0 cannot reach (0,4) any more"});
  EXPECT_EQ(ExecuteMissionResult::INCOMPLETE, result.outcome);
  EXPECT_EQ(1U, result.arrived);
  EXPECT_EQ("1 of 3 robots have arrived; robot_1 is lost; robot_0 cannot reach (0,4) any more",
            result.message);
}

TEST(IsExecutionOfTest, AsksForTheSameRobotsAndGoals) {
  AdgState state = finishedState();
  EXPECT_FALSE(isExecutionOf(smallMission(), state)) << "finished";
  state.phase = AdgState::EXECUTING;
  EXPECT_TRUE(isExecutionOf(smallMission(), state));
  state.robots[0].goal.col = 1;
  EXPECT_FALSE(isExecutionOf(smallMission(), state)) << "other goal";
  state.robots[0].condition = RobotExecution::LOST;
  EXPECT_TRUE(isExecutionOf(smallMission(), state)) << "a lost robot has none";
  state.robots.pop_back();
  EXPECT_FALSE(isExecutionOf(smallMission(), state)) << "a robot is missing";
}

TEST(AllHoldTest, NeedsAPauseAndRobotsAtRest) {
  AdgState state = finishedState();
  EXPECT_FALSE(allHold(state));
  state.mode = AdgState::PAUSE;
  EXPECT_TRUE(allHold(state));
  state.robots[1].report_state = sylph_msgs::TaskReport::MOVING;
  EXPECT_FALSE(allHold(state));
}

}  // namespace
}  // namespace sylph_planner_node
