#include "sylph_core/mission/mission_lifecycle.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mission_lifecycle_fixture.hpp"

namespace sylph {
namespace {

using Stage = MissionLifecycle::Stage;

class MissionLifecycleTest : public test::MissionLifecycleTest {};

TEST_F(MissionLifecycleTest, PlansSendsFollowsAndEnds) {
  execute();
  const MissionPlan plan = last<mission_command::Publish>().plan;
  EXPECT_EQ(1U, plan.plan_id);
  EXPECT_EQ(0U, plan.replaces_plan_id);
  EXPECT_EQ(smallStarts(), plan.plan.front());
  EXPECT_EQ(smallMission().goals, plan.plan.back());
  EXPECT_EQ("executing", lifecycle_.progress().phase);
  arrive();
  hear();
  EXPECT_EQ(MissionOutcome::Success, result().outcome) << result().message;
  EXPECT_EQ(3U, result().arrived);
  EXPECT_EQ(plan.steps(), result().plan_steps);
  EXPECT_EQ(1U, count<mission_command::Withdraw>());
  EXPECT_EQ(Stage::Idle, lifecycle_.stage());
}

TEST_F(MissionLifecycleTest, CarriesOutThePlanThatWasShown) {
  const CheckedPlan shown =
      planMission(smallMission(), toInstance(smallMission(), smallStarts(), {}));
  lifecycle_.begin(smallMission(), now_s_, shown);
  hear();
  EXPECT_EQ(Stage::Sending, lifecycle_.stage());
  EXPECT_EQ(0U, count<mission_command::Plan>());
  EXPECT_EQ(shown.plan, last<mission_command::Publish>().plan.plan);
}

TEST_F(MissionLifecycleTest, EndsWhenThePlanThatWasShownDoesNotFitAnyMore) {
  const CheckedPlan shown =
      planMission(smallMission(), toInstance(smallMission(), smallStarts(), {}));
  poses_["robot_1"].pose = pose2dIn(smallMission(), {2, 3});
  lifecycle_.begin(smallMission(), now_s_, shown);
  hear();
  EXPECT_EQ(MissionOutcome::BadRequest, result().outcome);
  EXPECT_EQ("robot_1 stands in (2,3), where the plan that was shown begins in (2,4): plan again",
            result().message);
  EXPECT_EQ(0U, count<mission_command::Publish>());
}

TEST_F(MissionLifecycleTest, WaitsForWordFromTheCentralNodeAfterTheMissionCame) {
  lifecycle_.onAdgState(state_, now_s_ - 0.1);
  lifecycle_.begin(smallMission(), now_s_);
  tick();
  EXPECT_EQ(Stage::Starting, lifecycle_.stage());
  hear();
  EXPECT_EQ(Stage::Planning, lifecycle_.stage());
}

TEST_F(MissionLifecycleTest, GivesUpOnASilentCentralNode) {
  lifecycle_.begin(smallMission(), now_s_);
  now_s_ += 9.9;
  tick();
  EXPECT_EQ(Stage::Starting, lifecycle_.stage());
  now_s_ += 0.2;
  tick();
  EXPECT_EQ(MissionOutcome::PlanRefused, result().outcome);
  EXPECT_EQ("the central node is silent: no message on /sylph/adg_state", result().message);
}

TEST_F(MissionLifecycleTest, WaitsForPosesOnlySoLong) {
  poses_.erase("robot_1");
  begin();
  EXPECT_EQ(Stage::Starting, lifecycle_.stage());
  now_s_ += 5.1;
  hear();
  EXPECT_EQ(MissionOutcome::NoPose, result().outcome);
  EXPECT_EQ("no pose of robot_1 has come", result().message);
}

TEST_F(MissionLifecycleTest, WaitsForBystandersToBeSeen) {
  Mission mission = smallMission();
  mission.robots.pop_back();
  mission.goals.pop_back();
  poses_.erase("robot_2");
  lifecycle_.begin(mission, now_s_);
  hear();
  EXPECT_EQ(Stage::Starting, lifecycle_.stage());
  ASSERT_EQ(1U, lifecycle_.progress().waiting.size());
  const std::string reason =
      "robot_2 has no part in the mission, but might stand in its way: no pose of it has come\n"
      "with ignore_unseen_robots the planner goes on without after pose_wait_s";
  EXPECT_EQ(reason, lifecycle_.progress().waiting.front());
  now_s_ += 5.1;
  hear();
  EXPECT_EQ(MissionOutcome::NoPose, result().outcome);
  EXPECT_EQ(reason, result().message);
  EXPECT_EQ(0U, count<mission_command::Plan>());
}

TEST_F(MissionLifecycleTest, GoesOnWithoutBystandersIfToldTo) {
  MissionLimits careless = test::testLimits();
  careless.ignores_unseen_robots = true;
  lifecycle_ = MissionLifecycle(smallLab().robots, careless, "");
  Mission mission = smallMission();
  mission.robots.pop_back();
  mission.goals.pop_back();
  poses_.erase("robot_2");
  lifecycle_.begin(mission, now_s_);
  hear();
  EXPECT_EQ(Stage::Starting, lifecycle_.stage()) << "its pose may be on its way";
  EXPECT_EQ(1U, lifecycle_.progress().waiting.size());
  now_s_ += 5.1;
  hear();
  EXPECT_EQ(Stage::Planning, lifecycle_.stage());
  EXPECT_EQ(
      "robot_2 has no part in the mission, but might stand in its way: no pose of it has come; it "
      "is ignored",
      last<mission_command::Say>().text);
}

TEST_F(MissionLifecycleTest, EndsWhenTheCentralNodeFallsSilentUnderWay) {
  execute();
  now_s_ += 10.1;
  tick();
  EXPECT_EQ("the central node is silent: no message on /sylph/adg_state", result().message);
}

TEST_F(MissionLifecycleTest, TellsWhatThePlanWaitsFor) {
  begin();
  plan();
  state_.plan_id = lifecycle_.planId();
  state_.phase = ExecutionPhase::Pending;
  state_.message = "robot_1 does not report";
  hear();
  EXPECT_EQ(std::vector<std::string>{"robot_1 does not report"}, lifecycle_.progress().waiting);
}

TEST_F(MissionLifecycleTest, EndsWhenTheCentralNodeDoesNotTakeThePlan) {
  begin();
  plan();
  now_s_ += 10.1;
  hear();
  EXPECT_EQ("the central node does not take plan 1: it has plan 0", result().message);
}

TEST_F(MissionLifecycleTest, EndsWithTheCentralNodesReason) {
  execute();
  state_.phase = ExecutionPhase::Refused;
  state_.message = "/run/events.jsonl: cannot be written: No space left on device";
  hear();
  EXPECT_EQ(MissionOutcome::PlanRefused, result().outcome);
  EXPECT_EQ("the central node has ended the plan: " + state_.message, result().message);
}

TEST_F(MissionLifecycleTest, SendsAgainWhatDidNotArrive) {
  begin();
  plan();
  now_s_ += 0.4;
  hear();
  EXPECT_EQ(0U, count<mission_command::PublishAgain>());
  now_s_ += 0.1;
  hear();
  EXPECT_EQ(1U, count<mission_command::PublishAgain>());
  EXPECT_EQ(Stage::Sending, lifecycle_.stage());
}

TEST_F(MissionLifecycleTest, SendsAPlanAgainThatTheCentralNodeHasLost) {
  execute();
  state_.plan_id = 0;
  state_.phase = ExecutionPhase::Idle;
  hear();
  EXPECT_EQ(1U, count<mission_command::PublishAgain>());
  EXPECT_EQ(Stage::Sending, lifecycle_.stage());
}

TEST_F(MissionLifecycleTest, NumbersPlansAfterThoseTheCentralNodeKnows) {
  state_.plan_id = 7;
  state_.last_plan_id = 12;
  begin();
  plan();
  EXPECT_EQ(13U, last<mission_command::Publish>().plan.plan_id);
}

TEST_F(MissionLifecycleTest, PassesOnWhyThePlanWasRefused) {
  begin();
  plan();
  state_.plan_id = lifecycle_.planId();
  state_.phase = ExecutionPhase::Refused;
  state_.message = "no safety margin";
  hear();
  EXPECT_EQ(MissionOutcome::PlanRefused, result().outcome);
  EXPECT_EQ("the central node refused the plan: no safety margin", result().message);
}

TEST_F(MissionLifecycleTest, EndsWhenThePlanOfAnotherMissionTakesOver) {
  execute();
  state_.plan_id = 5;
  hear();
  EXPECT_EQ(MissionOutcome::PlanRefused, result().outcome);
  EXPECT_EQ("plan 1 was replaced by plan 5 of another mission", result().message);
}

TEST_F(MissionLifecycleTest, EndsWithThePlannersReason) {
  begin();
  lifecycle_.onPlanned(MissionFailure(MissionOutcome::NoPlan, "step limit"), now_s_);
  take();
  EXPECT_EQ(MissionOutcome::NoPlan, result().outcome);
  EXPECT_EQ("step limit", result().message);
  EXPECT_EQ(0U, count<mission_command::Publish>());
}

TEST_F(MissionLifecycleTest, PlansTheRestAtTheCut) {
  execute();
  state_.robots[1].condition = RobotCondition::Lost;
  state_.phase = ExecutionPhase::Cutting;
  hear();
  EXPECT_EQ("cutting", lifecycle_.progress().phase);
  state_.phase = ExecutionPhase::AtCut;
  hear();
  EXPECT_EQ("replanning", lifecycle_.progress().phase);
  plan();
  const MissionPlan rest = last<mission_command::Publish>().plan;
  EXPECT_EQ(2U, rest.plan_id);
  EXPECT_EQ(1U, rest.replaces_plan_id);
  EXPECT_EQ((std::vector<std::string>{"robot_0", "robot_2"}), rest.robots);
  EXPECT_EQ(1U, lifecycle_.totals().replans);
}

TEST_F(MissionLifecycleTest, PlansAnewWhenAnotherRobotIsLostAtTheCut) {
  execute();
  state_.robots[1].condition = RobotCondition::Lost;
  state_.phase = ExecutionPhase::AtCut;
  hear();
  plan();
  ASSERT_EQ(Stage::Sending, lifecycle_.stage());
  hear();
  ASSERT_EQ(Stage::Sending, lifecycle_.stage());
  state_.robots[2].condition = RobotCondition::Lost;
  hear();
  plan();
  const MissionPlan rest = last<mission_command::Publish>().plan;
  EXPECT_EQ(3U, rest.plan_id);
  EXPECT_EQ(1U, rest.replaces_plan_id);
  EXPECT_EQ((std::vector<std::string>{"robot_0"}), rest.robots);
}

TEST_F(MissionLifecycleTest, PlansTheRestAroundBystandersToo) {
  Mission mission = smallMission();
  mission.robots = {"robot_0", "robot_1"};
  mission.goals = {{0, 3}, {2, 0}};
  lifecycle_.begin(mission, now_s_);
  hear();
  plan();
  state_.plan_id = lifecycle_.planId();
  state_.phase = ExecutionPhase::Executing;
  hear();
  state_.robots[1].condition = RobotCondition::Lost;
  state_.phase = ExecutionPhase::AtCut;
  hear();
  ASSERT_EQ(Stage::Planning, lifecycle_.stage());
  const PlanningOutcome rest = last<mission_command::Plan>().make();
  ASSERT_TRUE(std::holds_alternative<CheckedPlan>(rest));
  const Grid& grid = std::get<CheckedPlan>(rest).instance.grid;
  EXPECT_FALSE(grid.isFree(smallStarts()[2]));
  EXPECT_TRUE(grid.isFree({0, 3}));
}

TEST_F(MissionLifecycleTest, PausesAMissionThatIsCancelledUntilTheRobotsHold) {
  execute();
  lifecycle_.cancel(now_s_);
  hear();
  EXPECT_EQ(1U, count<mission_command::Pause>());
  EXPECT_EQ(Stage::Pausing, lifecycle_.stage());
  state_.mode = ExecutionMode::Pause;
  hear();
  EXPECT_EQ(Stage::Pausing, lifecycle_.stage()) << "a robot moves";
  state_.robots[0].report_state = RobotState::Holding;
  hear();
  EXPECT_EQ(MissionOutcome::Preempted, result().outcome);
  EXPECT_EQ("cancelled: the robots hold at their next cells", result().message);
}

TEST_F(MissionLifecycleTest, DoesNotWaitForEverForRobotsToHold) {
  execute();
  lifecycle_.cancel(now_s_);
  now_s_ += 8.1;
  hear();
  EXPECT_EQ("cancelled; the central node does not say that robots hold", result().message);
}

TEST_F(MissionLifecycleTest, ForgetsThePlanOfAMissionThatIsCancelledBeforeItIsMade) {
  begin();
  lifecycle_.cancel(now_s_);
  hear();
  EXPECT_EQ("cancelled before a robot moved", result().message);
  EXPECT_EQ(0U, count<mission_command::Pause>());
  begin();
  EXPECT_EQ(Stage::Starting, lifecycle_.stage()) << "the thread is still at work";
  lifecycle_.onPlanned(last<mission_command::Plan>().make(), now_s_);
  take();
  EXPECT_EQ(0U, count<mission_command::Publish>());
  hear();
  EXPECT_EQ(2U, count<mission_command::Plan>());
}

TEST_F(MissionLifecycleTest, LiftsItsOwnPauseWithTheNextMission) {
  supersede(ExecutionMode::Run, ExecutionMode::Pause);
  EXPECT_EQ(1U, count<mission_command::Resume>());
}

TEST_F(MissionLifecycleTest, LeavesAnOperatorsPauseAlone) {
  state_.mode = ExecutionMode::Pause;
  execute();
  arrive();
  hear();
  EXPECT_EQ(0U, count<mission_command::Resume>());
}

TEST_F(MissionLifecycleTest, LeavesRobotsHaltedThatAnOperatorHasHalted) {
  supersede(ExecutionMode::Pause, ExecutionMode::Pause);
  EXPECT_EQ(0U, count<mission_command::Resume>());
}

TEST_F(MissionLifecycleTest, LeavesRobotsStoppedThatAnOperatorHasStopped) {
  supersede(ExecutionMode::Stop, ExecutionMode::Stop);
  EXPECT_EQ(0U, count<mission_command::Resume>());
}

TEST_F(MissionLifecycleTest, LeavesRobotsStoppedThatAreStoppedWhileItsOwnPauseHolds) {
  supersede(ExecutionMode::Run, ExecutionMode::Stop);
  EXPECT_EQ(0U, count<mission_command::Resume>());
}

TEST_F(MissionLifecycleTest, RefusesToStartWhileAnotherPlanIsCarriedOut) {
  state_.plan_id = 9;
  state_.phase = ExecutionPhase::Executing;
  state_.robots[0].goal = {1, 1};
  begin();
  EXPECT_EQ(MissionOutcome::BadRequest, result().outcome);
  EXPECT_EQ("plan 9 of another mission is being carried out: cancel that one first",
            result().message);
}

TEST_F(MissionLifecycleTest, GoesOnWithItsMissionAfterARestart) {
  state_.plan_id = 9;
  state_.phase = ExecutionPhase::Executing;
  begin();
  EXPECT_EQ(Stage::Executing, lifecycle_.stage());
  EXPECT_EQ(9U, lifecycle_.planId());
  EXPECT_EQ(0U, count<mission_command::Plan>());
  EXPECT_EQ(0U, count<mission_command::Resume>());
}

TEST(OutcomeOfTest, IsThePlanOrWhyThereIsNone) {
  EXPECT_TRUE(std::holds_alternative<CheckedPlan>(outcomeOf([] { return CheckedPlan(); })));
  const PlanningOutcome failed = outcomeOf(
      []() -> CheckedPlan { throw MissionFailure(MissionOutcome::NoPose, "no pose of cf1"); });
  EXPECT_EQ(MissionOutcome::NoPose, std::get<MissionFailure>(failed).outcome());
  const PlanningOutcome broken =
      outcomeOf([]() -> CheckedPlan { throw std::runtime_error("bad weights"); });
  EXPECT_EQ(MissionOutcome::NoPlan, std::get<MissionFailure>(broken).outcome());
  EXPECT_STREQ("bad weights", std::get<MissionFailure>(broken).what());
}

TEST_F(MissionLifecycleTest, EndsARequestThatIsNoMission) {
  lifecycle_.fail({MissionOutcome::BadRequest, "unknown robot 'robot_9'"}, now_s_);
  take();
  EXPECT_EQ(MissionOutcome::BadRequest, result().outcome);
  EXPECT_EQ("unknown robot 'robot_9'", result().message);
  EXPECT_EQ(0U, result().robots);
}

}  // namespace
}  // namespace sylph
