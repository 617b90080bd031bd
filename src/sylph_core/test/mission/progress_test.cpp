#include "sylph_core/mission/progress.hpp"

#include <gtest/gtest.h>

#include "small_lab.hpp"

namespace sylph {
namespace {

/// All robots of the small mission on their goals.
AdgState finishedState() {
  const Mission mission = smallMission();
  AdgState state;
  state.plan_id = 1;
  state.phase = ExecutionPhase::Finished;
  state.elapsed_s = 12.5;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    RobotExecution robot;
    robot.robot = mission.robots[i];
    robot.cell = mission.goals[i];
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
  robot.waited_s = 1.23;
  robot.waits_for_robot = "robot_1";
  robot.waits_for_cell = Cell{2, 3};
  robot.root_cause_robot = "robot_2";
  robot.root_cause = "has no good pose";
  state.robots[2].condition = RobotCondition::Blind;
  const std::vector<std::string> lines = waitingLines(state);
  ASSERT_EQ(2U, lines.size());
  EXPECT_EQ("robot_0 waits 1.2 s for robot_1 to leave (2,3); held up by robot_2: has no good pose",
            lines[0]);
  EXPECT_EQ("robot_2 has no good pose", lines[1]);
  state.robots[2].root_cause = "no good pose: pose is frozen";
  EXPECT_EQ("robot_2: no good pose: pose is frozen", waitingLines(state)[1]);
}

TEST(WaitingLinesTest, BeginWithAPause) {
  AdgState state = finishedState();
  EXPECT_TRUE(waitingLines(state).empty());
  state.mode = ExecutionMode::Pause;
  state.message = "operator";
  EXPECT_EQ("paused: operator; sylph_resume goes on", waitingLines(state).front());
}

TEST(WaitingLinesTest, BeginWithWhatTheCentralNodeHasToSay) {
  AdgState state = finishedState();
  state.phase = ExecutionPhase::Executing;
  state.message = "plan 1 of an earlier launch is resumed";
  EXPECT_EQ(std::vector<std::string>{state.message}, waitingLines(state));
}

TEST(ProgressTest, CountsTasksAndArrivals) {
  AdgState state = finishedState();
  state.robots[1].tasks_done = 1;
  const MissionProgress progress = progressOf("executing", smallMission(), state);
  EXPECT_EQ("executing", progress.phase);
  EXPECT_EQ(9U, progress.tasks_done);
  EXPECT_EQ(12U, progress.tasks_total);
  EXPECT_EQ(2U, progress.robots_arrived);
}

TEST(FinishedResultTest, IsSuccessOnlyIfAllAreOnTheirGoals) {
  const auto result = finishedResult(smallMission(), finishedState(), {});
  EXPECT_EQ(MissionOutcome::Success, result.outcome);
  EXPECT_EQ(3U, result.arrived);
  EXPECT_EQ(3U, result.robots);
  EXPECT_DOUBLE_EQ(12.5, result.execution_s);
}

TEST(FinishedResultTest, SaysWhoDidNotArriveAndWhy) {
  AdgState state = finishedState();
  state.robots[1].condition = RobotCondition::Lost;
  state.robots[0].cell = Cell{0, 3};
  const auto result =
      finishedResult(smallMission(), state, {"robot_0 cannot reach (0,4) any more"});
  EXPECT_EQ(MissionOutcome::Incomplete, result.outcome);
  EXPECT_EQ(1U, result.arrived);
  EXPECT_EQ("1 of 3 robots have arrived; robot_1 is lost; robot_0 cannot reach (0,4) any more",
            result.message);
}

TEST(IsExecutionOfTest, AsksForTheSameRobotsAndGoals) {
  AdgState state = finishedState();
  EXPECT_FALSE(isExecutionOf(smallMission(), state)) << "finished";
  state.phase = ExecutionPhase::Executing;
  EXPECT_TRUE(isExecutionOf(smallMission(), state));
  state.robots[0].goal.col = 1;
  EXPECT_FALSE(isExecutionOf(smallMission(), state)) << "other goal";
  state.robots[0].condition = RobotCondition::Lost;
  EXPECT_TRUE(isExecutionOf(smallMission(), state)) << "a lost robot has none";
  state.robots.pop_back();
  EXPECT_FALSE(isExecutionOf(smallMission(), state)) << "a robot is missing";
}

TEST(AllHoldTest, NeedsAPauseAndRobotsAtRest) {
  AdgState state = finishedState();
  EXPECT_FALSE(allHold(state));
  state.mode = ExecutionMode::Pause;
  EXPECT_TRUE(allHold(state));
  state.robots[1].report_state = RobotState::Moving;
  EXPECT_FALSE(allHold(state));
}

}  // namespace
}  // namespace sylph
