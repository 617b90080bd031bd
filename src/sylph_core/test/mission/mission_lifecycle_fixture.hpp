#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <variant>
#include <vector>

#include "small_lab.hpp"
#include "sylph_core/mission/mission_lifecycle.hpp"

namespace sylph::test {

/// Of the missions of the tests: shorter than in a lab, and unlike one another.
inline MissionLimits testLimits() {
  MissionLimits limits;
  limits.resend_period_s = 0.5;
  limits.pose_wait_s = 5.0;
  limits.central_wait_s = 10.0;
  limits.hold_wait_s = 8.0;
  limits.replanning_time_limit_s = 0.2;
  return limits;
}

/// The small lab; the clock stands still unless a test moves it, and each command that was given is
/// kept.
class MissionLifecycleTest : public testing::Test {
 protected:
  MissionLifecycleTest() {
    const Mission mission = smallMission();
    for (std::size_t i = 0; i < mission.robots.size(); ++i) {
      RobotExecution robot;
      robot.robot = mission.robots[i];
      robot.cell = smallStarts()[i];
      robot.held_cells = {robot.cell};
      robot.goal = mission.goals[i];
      state_.robots.push_back(robot);
    }
  }

  void take() {
    for (MissionCommand& command : lifecycle_.takeCommands()) {
      commands_.push_back(std::move(command));
    }
  }

  void tick() {
    lifecycle_.tick(poses_, now_s_);
    take();
  }

  /// The central node says `state_`, then time for a tick.
  void hear() {
    lifecycle_.onAdgState(state_, now_s_);
    tick();
  }

  /// The last command of its kind, which the test expects to be there.
  template <typename Command>
  Command last() const {
    for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) {
      if (const auto* found = std::get_if<Command>(&*command)) {
        return *found;
      }
    }
    ADD_FAILURE() << "no such command";
    return {};
  }

  template <typename Command>
  std::size_t count() const {
    std::size_t found = 0;
    for (const MissionCommand& command : commands_) {
      found += std::holds_alternative<Command>(command) ? 1 : 0;
    }
    return found;
  }

  MissionResult result() const { return last<mission_command::End>().result; }

  void plan() {
    ASSERT_EQ(MissionLifecycle::Stage::Planning, lifecycle_.stage());
    lifecycle_.onPlanned(last<mission_command::Plan>().make(), now_s_);
    take();
  }

  void begin() {
    lifecycle_.begin(smallMission(), now_s_);
    hear();
  }

  /// The central node carries out the plan that was sent.
  void execute() {
    begin();
    plan();
    ASSERT_EQ(MissionLifecycle::Stage::Sending, lifecycle_.stage());
    state_.plan_id = lifecycle_.planId();
    state_.phase = ExecutionPhase::Executing;
    state_.robots[0].report_state = RobotState::Moving;
    hear();
    ASSERT_EQ(MissionLifecycle::Stage::Executing, lifecycle_.stage());
  }

  /// Another mission takes the place of the one that is carried out.
  /// @param before, after  the execution's mode, as it has been, and when the other one begins
  void supersede(ExecutionMode before, ExecutionMode after) {
    execute();
    state_.mode = before;
    hear();
    lifecycle_.supersede(now_s_);
    take();
    EXPECT_EQ(MissionOutcome::Preempted, result().outcome);
    EXPECT_EQ(1U, count<mission_command::Pause>());
    Mission other = smallMission();
    other.goals[1] = {1, 0};
    lifecycle_.begin(other, now_s_);
    hear();
    EXPECT_EQ(MissionLifecycle::Stage::Starting, lifecycle_.stage())
        << "robots of the old mission move";
    state_.mode = after;
    state_.robots[0].report_state = RobotState::Holding;
    hear();
    plan();
    EXPECT_EQ(0U, count<mission_command::Resume>());
    state_.plan_id = lifecycle_.planId();
    hear();
    EXPECT_EQ(MissionLifecycle::Stage::Executing, lifecycle_.stage());
  }

  void arrive() {
    for (RobotExecution& robot : state_.robots) {
      robot.cell = robot.goal;
      robot.report_state = RobotState::Idle;
    }
    state_.phase = ExecutionPhase::Finished;
  }

  double now_s_ = 100.0;
  RobotPoses poses_ = posesInStarts();
  AdgState state_;
  MissionLifecycle lifecycle_{smallLab().robots, testLimits(), "/sylph/adg_state"};
  std::vector<MissionCommand> commands_;
};

}  // namespace sylph::test
