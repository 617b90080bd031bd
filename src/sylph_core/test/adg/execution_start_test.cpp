#include <gtest/gtest.h>

#include <cmath>

#include "execution_fixture.hpp"

// How plans begin: which are refused, what a plan waits for, which takes another one's place.

namespace sylph {
namespace {

using test::missionPlan;
using test::queue;

class ExecutionStartTest : public test::ExecutionTest {};

TEST_F(ExecutionStartTest, RefusesAPlanThatDoesNotStartWhereRobotsAre) {
  place({{0, 0}, {1, 1}, {0, 2}});
  submit(queue(), 1);
  EXPECT_EQ(ExecutionPhase::Refused, execution_->phase());
  EXPECT_EQ("plan 1: robot_1 is in (1,1), and not in its start (0,1)", execution_->message());
}

TEST_F(ExecutionStartTest, RefusesAStartOffTheCentre) {
  place(queue().front());
  robots_[1].position.x += 0.05;
  robots_[2].yaw_rad = 0.5;
  report(1);
  report(2);
  submit(queue(), 1);
  EXPECT_EQ(
      "plan 1: robot_1 stands 50 mm in x and 0 mm in y off the centre of its start (0,1), turned "
      "by 0 deg: allowed are 27 and 42 mm, turned like that\n"
      "robot_2 stands 0 mm in x and 0 mm in y off the centre of its start (0,2), turned by 29 deg: "
      "allowed are 0 and 0 mm, turned like that",
      execution_->message());
}

TEST_F(ExecutionStartTest, AllowsAStartThatKeepsToTheMiddleOfItsCell) {
  place(queue().front());
  robots_[0].position.y += 0.04;
  robots_[1].position.x += 0.02;
  robots_[2].yaw_rad = 0.1;
  reportAll();
  submit(queue(), 1);
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
}

TEST_F(ExecutionStartTest, RefusesASwapByNames) {
  const Configuration from = {{0, 0}, {0, 1}, {1, 1}};
  place(from);
  submit({from, {{0, 1}, {0, 0}, {1, 1}}}, 1);
  EXPECT_EQ(
      "plan 1: step 0: robot_0, robot_1 swap their cells, so that each would wait for the next one "
      "for ever",
      execution_->message());
}

TEST_F(ExecutionStartTest, RefusesWhatIsNotOfThisLab) {
  place(queue().front());
  execution_->submit(missionPlan(queue(), {"robot_0", "robot_1", "robot_7"}, 1), now_s_);
  EXPECT_EQ("plan 1: robot 'robot_7' is not in the lab", execution_->message());
  execution_->submit(missionPlan(queue(), {"robot_0", "robot_1", "robot_1"}, 2), now_s_);
  EXPECT_EQ("plan 2: robot_1 appears twice", execution_->message());
  submit({{{0, 0}, {0, 1}, {0, 2}}, {{-1, 0}, {0, 1}, {0, 2}}}, 3);
  EXPECT_NE(std::string::npos, execution_->message().find("not a free cell"));
  submit(queue(), 4);
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase()) << "a refusal is not the end";
}

TEST_F(ExecutionStartTest, RefusesAnIdThatIsNotNew) {
  place(queue().front());
  robots_[2].plan_id = 7;  // what a robot remembers of an earlier run
  report(2);
  EXPECT_EQ(7U, execution_->lastPlanId());
  submit(queue(), 7);
  EXPECT_EQ("plan 7: its id is not greater than 7, which is the last one in use",
            execution_->message());
  submit(queue(), 8);
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
}

TEST_F(ExecutionStartTest, RefusesAnIdThatARobotKnowsWhichIsHeardLate) {
  submit(queue(), 1);
  EXPECT_EQ(ExecutionPhase::Pending, execution_->phase());
  robots_[2].plan_id = 1;  // of an earlier run, done
  robots_[2].done = 4;
  place(queue().front());
  EXPECT_EQ(
      "plan 1: robot_2 has tasks of plan 1 from before the central node was launched: send "
      "the mission again",
      execution_->message());
  submit(queue(), 2);
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
}

TEST_F(ExecutionStartTest, RefusesToDriveThroughABystander) {
  place({{0, 0}, {0, 3}, {0, 1}});
  submit({{{0, 0}, {0, 3}}, {{0, 1}, {0, 3}}}, 1, 0, {"robot_0", "robot_1"});
  EXPECT_EQ("plan 1: it leads through (0,1), where robot_2 stands, which takes no part",
            execution_->message());
}

TEST_F(ExecutionStartTest, RefusesToDrivePastABystanderThatReachesOverItsCell) {
  place({{0, 0}, {0, 3}, {1, 1}});
  robots_[2].position.y += 0.03;  // 5 mm short of (0,1), where a neighbour may come as near
  robots_[2].yaw_rad = M_PI / 2.0;
  report(2);
  submit({{{0, 0}, {0, 3}}, {{0, 1}, {0, 3}}}, 1, 0, {"robot_0", "robot_1"});
  EXPECT_EQ("plan 1: it leads through (0,1), where robot_2 stands, which takes no part",
            execution_->message());
  robots_[2].position.y -= 0.03;
  report(2);
  submit({{{0, 0}, {0, 3}}, {{0, 1}, {0, 3}}}, 2, 0, {"robot_0", "robot_1"});
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase()) << execution_->message();
}

TEST_F(ExecutionStartTest, WaitsForReportsAndThenRefuses) {
  submit(queue(), 1);
  EXPECT_EQ(ExecutionPhase::Pending, execution_->phase());
  place(queue().front());
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
  restart();
  now_s_ += 100.0;
  submit(queue(), 1);
  now_s_ += limits_.start_wait_s + 0.1;
  execution_->tick(now_s_);
  EXPECT_EQ("plan 1: robot_0 does not report; robot_1 does not report; robot_2 does not report",
            execution_->message());
}

TEST_F(ExecutionStartTest, NamesAllThatAreWaitedForAndFirstWhoIsNotThere) {
  robots_[0].state = RobotState::Blind;
  robots_[0].detail = "pose is 0.2 s old";
  robots_[0].position = frame_.toPoint({0, 0});
  report(0);
  robots_[1].position = frame_.toPoint({0, 1});
  report(1);
  submit(queue(), 1);
  EXPECT_EQ("robot_2 does not report; robot_0 has no good pose: pose is 0.2 s old",
            execution_->message());
}

TEST_F(ExecutionStartTest, AReplacementNeedsACut) {
  place(queue().front());
  submit(queue(), 1);
  execution_->submit(missionPlan(queue(), names_, 2, 1), now_s_);
  EXPECT_EQ("plan 2: it replaces a plan that is not cut: no robot has been declared lost",
            execution_->message());
  execution_->submit(missionPlan(queue(), names_, 3, 9), now_s_);
  EXPECT_EQ("plan 3: it replaces plan 9, but plan 1 is carried out", execution_->message());
}

TEST_F(ExecutionStartTest, ANewMissionWaitsUntilRobotsRest) {
  place(queue().front());
  submit(queue(), 1);
  const Configuration at_rest = {{0, 0}, {0, 1}, {0, 4}};
  submit({at_rest, {{0, 0}, {0, 1}, {1, 4}}}, 2);
  EXPECT_EQ(ExecutionPhase::Pending, execution_->phase()) << "robot 2 has tasks of plan 1";
  ASSERT_TRUE(stepUntil(ExecutionPhase::Finished));
  EXPECT_EQ(2U, execution_->planId());
  EXPECT_EQ((Cell{1, 4}), view(2).cell);
  EXPECT_EQ(0, robots_[1].done) << "plan 1 was given up";
}

TEST_F(ExecutionStartTest, WhatIsKnownOrOlderChangesNothing) {
  place(queue().front());
  submit(queue(), 2);
  step();
  const auto before = execution_->graph()->configuration();
  submit(queue(), 2);
  submit(queue(), 1);
  execution_->refuse(2, "malformed");
  execution_->refuse(1, "malformed");
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
  EXPECT_EQ(2U, execution_->planId());
  EXPECT_EQ(before, execution_->graph()->configuration());
}

TEST_F(ExecutionStartTest, APendingPlanIsTakenAgainAfterARestart) {
  submit(queue(), 1);
  EXPECT_EQ(ExecutionPhase::Pending, execution_->phase());
  restart();
  for (const ExecutionEvent& event : log_) {
    execution_->replay(event);
  }
  EXPECT_EQ(ExecutionPhase::Pending, execution_->phase());
  submit(queue(), 1);
  place(queue().front());
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase()) << execution_->message();
}

TEST_F(ExecutionStartTest, RefusesAPlanThatExtendsAnother) {
  place(queue().front());
  MissionPlan plan = missionPlan(queue(), names_, 1);
  plan.first_step = 3;
  execution_->submit(plan, now_s_);
  EXPECT_EQ("plan 1: it begins at timestep 3: must be 0", execution_->message());
}

}  // namespace
}  // namespace sylph
