#include "sylph_rviz/operator_model.hpp"

#include <gtest/gtest.h>

#include "mission/small_lab.hpp"
#include "test_scene.hpp"

namespace sylph_rviz {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

/// A model that has heard the state of two robots at the steady time 0.
class OperatorModelTest : public ::testing::Test {
 protected:
  OperatorModelTest() : state(*twoRobots().state) {
    state.steps = 10;
    model.setSource(Source::Live, true);
  }
  void hear(double steady_s = 0.0) { model.onState(state, steady_s); }
  RobotRow row(std::size_t index) { return model.view(0.0, 0.0).rows.at(index); }

  AdgState state;
  OperatorModel model;
};

TEST_F(OperatorModelTest, HasARowForEachRobotInTheOrderOfTheLab) {
  hear();
  const OperatorView view = model.view(0.0, 0.0);
  ASSERT_EQ(2U, view.rows.size());
  EXPECT_EQ("robot_0", view.rows[0].name);
  EXPECT_EQ("drives", view.rows[0].state);
  EXPECT_EQ("robot_1", view.rows[0].partner);
  EXPECT_DOUBLE_EQ(25.0, view.rows[0].svo_deg.value());
  EXPECT_EQ("arrived", view.rows[1].state);
  EXPECT_FALSE(view.rows[1].svo_deg) << "the planner gives none";
  EXPECT_EQ(3, view.tasks_total);
  EXPECT_EQ("executing, 1 of 2 robots arrived", view.headline);
}

TEST_F(OperatorModelTest, TellsTheSvosOfTheSelectedRobotAndItsPartnerInThePlanThatIsCarriedOut) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  sylph::MissionPlan plan;
  plan.plan_id = 1;
  plan.robots = {"robot_1", "robot_0"};
  plan.social = {{{1, 0}, {10.0F, 20.0F}}, {{1, 0}, {none, 25.0F}}};
  state.robots[0].step = 1;
  hear();
  EXPECT_TRUE(model.view(0.0, 0.0).svo.empty()) << "none is selected";
  model.select("robot_0");
  EXPECT_TRUE(model.view(0.0, 0.0).svo.empty()) << "the plan has not come";
  model.onPlan(plan);
  const OperatorView view = model.view(0.0, 0.0);
  ASSERT_EQ(2U, view.svo.size());
  EXPECT_EQ("robot_0", view.svo[0].robot);
  EXPECT_EQ((std::vector<float>{20.0F, 25.0F}), view.svo[0].svo_deg);
  EXPECT_EQ("robot_1", view.svo[1].robot);
  EXPECT_EQ(10.0F, view.svo[1].svo_deg.at(0));
  EXPECT_EQ(1U, view.svo_step);
  plan.social = {{{1, 0}, {10.0F, none}}, {{1, 0}, {10.0F, none}}};
  model.onPlan(plan);
  ASSERT_EQ(0U, model.view(0.0, 0.0).svo.size())
      << "the robot has none, its partner's alone says nothing";
  plan.plan_id = 2;
  plan.social = {{{1, 0}, {10.0F, 20.0F}}};
  model.onPlan(plan);
  EXPECT_TRUE(model.view(0.0, 0.0).svo.empty()) << "of a plan that is not carried out yet";
}

TEST_F(OperatorModelTest, TellsWhereAReplayIs) {
  hear();
  sylph_msgs::ReplayExtent extent;
  extent.begin = ros::Time(100.0);
  extent.length = ros::Duration(60.0);
  model.onReplayExtent(extent);
  EXPECT_FALSE(model.view(112.0, 0.0).replay) << "this is none";
  model.setSource(Source::Replay, false);
  EXPECT_DOUBLE_EQ(12.0, model.view(112.0, 0.0).replay.value().at_s);
  EXPECT_DOUBLE_EQ(60.0, model.view(112.0, 0.0).replay.value().length_s);
  EXPECT_DOUBLE_EQ(0.0, model.view(0.0, 0.0).replay.value().at_s) << "before the first clock";
}

TEST_F(OperatorModelTest, TellsForWhomARobotWaitsHowLongAndWhoIsTheCause) {
  RobotExecution& robot = state.robots[0];
  robot.waiting = 1;
  robot.waits_for_robot = "robot_1";
  robot.waits_for_cell.row = 3;
  robot.waits_for_cell.col = 4;
  robot.waited_s = 5.25;
  robot.root_cause_robot = "robot_7";
  robot.root_cause = "no good pose";
  hear();
  EXPECT_EQ("waits", row(0).state);
  EXPECT_EQ("robot_1, 5.2 s", row(0).waits);
  EXPECT_EQ("waits 5.2 s for robot_1 to leave (3,4); cause: robot_7, no good pose", row(0).reason);
}

TEST_F(OperatorModelTest, TellsTheChainOfWaitsOfARobotLinkByLink) {
  for (std::size_t i = 0; i < 2; ++i) {
    state.robots[i].tasks_total = 3;
    state.robots[i].waiting = i == 0 ? 1 : 0;
    state.robots[i].task_status = 1;
  }
  state.robots[0].waits_for_robot = "robot_1";
  state.robots[0].waited_s = 2.0;
  hear();
  EXPECT_EQ((std::vector<std::string>{"robot_0 waits 2.0 s for robot_1 to leave (0,0)",
                                      "robot_1 drives"}),
            row(0).chain);
  EXPECT_TRUE(row(1).chain.empty());
  state.robots[1].condition = RobotExecution::STUCK;
  state.robots[1].root_cause = "has not moved for 6 s";
  hear();
  EXPECT_EQ("robot_1 has not moved for 6 s", row(0).chain.at(1));
}

TEST_F(OperatorModelTest, ShowsAFaultWithItsReason) {
  state.robots[0].condition = RobotExecution::SILENT;
  state.robots[0].root_cause = "has sent no report for 3 s";
  hear();
  EXPECT_EQ("SILENT", row(0).state);
  EXPECT_EQ("has sent no report for 3 s", row(0).reason);
}

TEST_F(OperatorModelTest, MeasuresPoseAgeInRosTimeAndErrorFromTheWay) {
  hear();
  model.onPose("robot_0", {0.17, 0.3, 0.0}, 100.0);
  EXPECT_DOUBLE_EQ(0.25, model.view(100.25, 0.0).rows[0].pose_age_s.value());
  EXPECT_DOUBLE_EQ(0.0, model.view(99.0, 0.0).rows[0].pose_age_s.value()) << "a replay begins anew";
  EXPECT_FALSE(row(0).tracking_error_m) << "without a map";
  nav_msgs::OccupancyGrid map;
  map.info.width = 5;
  map.info.height = 4;
  map.info.resolution = 0.3F;
  model.onMap(map);
  EXPECT_NEAR(0.02, row(0).tracking_error_m.value(), 1e-6) << "it drives north along x = 0.15";
  EXPECT_FALSE(row(1).tracking_error_m) << "without a pose";
}

TEST_F(OperatorModelTest, TellsNoCellOfARobotWithoutAPose) {
  hear();
  EXPECT_EQ("(3,0)", row(0).cell);
  state.robots[0] = RobotExecution();  // no part in the mission, and no pose that was heard
  state.robots[0].robot_id = "robot_0";
  hear();
  EXPECT_EQ("no pose", row(0).cell);
  model.onPose("robot_0", {0.4, 0.2, 0.0}, 0.0);
  EXPECT_EQ("", row(0).cell) << "without a map";
  nav_msgs::OccupancyGrid map;
  map.info.width = 5;
  map.info.height = 4;
  map.info.resolution = 0.3F;
  model.onMap(map);
  EXPECT_EQ("(3,1)", row(0).cell);
  EXPECT_FALSE(row(0).tracking_error_m) << "it has no way to drive";
}

TEST_F(OperatorModelTest, EstimatesTheTimeLeftByThePaceOfTheRobotFurthestBehind) {
  state.elapsed_s = 8.0;
  state.robots[0].step = 2;
  hear();
  EXPECT_FALSE(model.view(0.0, 0.0).left_s) << "too early";
  state.robots[0].step = 4;
  hear();
  EXPECT_DOUBLE_EQ(12.0, model.view(0.0, 0.0).left_s.value());
}

TEST_F(OperatorModelTest, RefusesCommandsThatMakeNoSenseNow) {
  hear();
  OperatorView view = model.view(0.0, 0.0);
  EXPECT_EQ("a mission is under way: cancel it first", view.start);
  EXPECT_EQ("", view.pause);
  EXPECT_EQ("robots are free to go", view.resume);
  EXPECT_EQ("", view.stop);
  EXPECT_EQ("", view.cancel);

  state.phase = AdgState::FINISHED;
  state.mode = AdgState::STOP;
  hear();
  view = model.view(0.0, 0.0);
  EXPECT_EQ("stopped: resume first", view.start);
  EXPECT_EQ("", view.resume);
  EXPECT_EQ("stopped already", view.stop);
  EXPECT_EQ("no mission is under way", view.cancel);

  state.mode = AdgState::RUN;
  hear();
  EXPECT_EQ("", model.view(0.0, 0.0).start);
  model.setSource(Source::Live, false);
  EXPECT_EQ("no planner takes missions", model.view(0.0, 0.0).start);
}

TEST_F(OperatorModelTest, ACentralNodeThatIsNotHeardCanStillBeStopped) {
  hear();
  const OperatorView view = model.view(0.0, 5.0);
  EXPECT_EQ("no central node", view.headline);
  EXPECT_EQ("no central node is heard", view.pause);
  EXPECT_EQ("", view.stop);
}

TEST_F(OperatorModelTest, AReplayIsShownAndNotCommanded) {
  model.setSource(Source::Replay, false);
  hear();
  const OperatorView view = model.view(0.0, 1000.0);  // paused for long
  EXPECT_EQ("replay: executing, 1 of 2 robots arrived", view.headline);
  for (const Refusal& refusal :
       {view.start, view.pause, view.resume, view.stop, view.cancel, view.confirm_pose,
        view.set_goal, view.plan, view.go, view.clear_goals, view.save}) {
    EXPECT_EQ("a replay: no robot hears commands", refusal);
  }
}

TEST_F(OperatorModelTest, GoalsAreSetByHandBetweenMissions) {
  hear();
  nav_msgs::OccupancyGrid map;
  map.info.width = 5;
  map.info.height = 3;
  map.info.resolution = 0.3F;
  model.onMap(map);
  model.onPose("robot_0", {0.2, 0.7, 0.0}, 0.0);
  EXPECT_EQ("a mission is under way: cancel it first", model.view(0.0, 0.0).set_goal);
  ASSERT_EQ(1U, model.handles(0.0).size()) << "robot_1 has no pose";
  EXPECT_FALSE(model.handles(0.0)[0].goal);

  state.phase = AdgState::FINISHED;
  hear();
  EXPECT_EQ("the lab's experiment is not known here", model.view(0.0, 0.0).plan);
  model.desk().setLab(sylph::smallLab());
  OperatorView view = model.view(0.0, 0.0);
  EXPECT_EQ("", view.set_goal);
  EXPECT_EQ("no goal is set", view.save);
  ASSERT_TRUE(model.handles(0.0)[0].goal) << "to be dragged from the robot's cell";
  EXPECT_TRUE(model.handles(0.0)[0].is_on_robot);
  EXPECT_NEAR(0.15, model.handles(0.0)[0].goal->x, 1e-6);
  EXPECT_NEAR(0.75, model.handles(0.0)[0].goal->y, 1e-6);

  model.desk().set("robot_0", {0.75, 0.75}, model.poses());
  EXPECT_FALSE(model.handles(0.0)[0].is_on_robot);
  EXPECT_NEAR(0.75, model.handles(0.0)[0].goal->x, 1e-6);
  view = model.view(0.0, 0.0);
  EXPECT_EQ("robot_0 to (0,2); 2 robots stay", view.goals);
  EXPECT_EQ("", view.plan);
  EXPECT_EQ("", view.save);
  EXPECT_EQ("plan first", view.go);
  model.setSource(Source::Live, false);
  EXPECT_EQ("no planner takes missions", model.view(0.0, 0.0).plan);
}

TEST_F(OperatorModelTest, ShowsThePlannersPhaseAndHowTheMissionEnded) {
  state.phase = AdgState::IDLE;
  hear();
  sylph_msgs::ExecuteMissionFeedback feedback;
  feedback.phase = "planning";
  model.onFeedback(feedback, 0.0);
  EXPECT_EQ("planning", model.view(0.0, 0.0).headline);
  feedback.phase = "waiting";
  feedback.waiting = {"no pose of robot_1 has come", "robot_2 has no good pose"};
  model.onFeedback(feedback, 0.0);
  EXPECT_EQ("no pose of robot_1 has come; robot_2 has no good pose", model.view(0.0, 0.0).message);
  EXPECT_FALSE(model.view(0.0, 0.0).is_alarm);
  EXPECT_EQ("a mission is under way: cancel it first", model.view(0.0, 0.0).start);

  sylph_msgs::ExecuteMissionResult result;
  result.outcome = sylph_msgs::ExecuteMissionResult::NO_POSE;
  result.message = "no pose of robot_1 has come";
  model.onResult(result);
  const OperatorView view = model.view(0.0, 0.0);
  EXPECT_EQ("no mission", view.headline);
  EXPECT_EQ("NO_POSE: no pose of robot_1 has come", view.message);
  EXPECT_TRUE(view.is_alarm);
  EXPECT_EQ("", view.start);
}

TEST_F(OperatorModelTest, TellsWhatTheMotionCaptureLacksWhileThereIsNoPlan) {
  const std::string finding = "sylph/mocap_bridge: link: no frame from 192.168.1.2";
  state.phase = AdgState::IDLE;
  hear();
  model.setCaptureFindings({finding});
  EXPECT_EQ(finding, model.view(0.0, 0.0).message);
  EXPECT_TRUE(model.view(0.0, 0.0).is_alarm);
  sylph_msgs::ExecuteMissionFeedback feedback;
  feedback.waiting = {"no pose of robot_1 has come"};
  model.onFeedback(feedback, 0.0);
  EXPECT_EQ("no pose of robot_1 has come; " + finding, model.view(0.0, 0.0).message);
  state.phase = AdgState::EXECUTING;
  hear();
  EXPECT_EQ("", model.view(0.0, 0.0).message);
  state.phase = AdgState::IDLE;
  hear();
  model.setSource(Source::Replay, false);
  EXPECT_EQ("no pose of robot_1 has come", model.view(0.0, 0.0).message);
}

TEST(DurationTextTest, SpeaksOfMinutesAboveOne) {
  EXPECT_EQ("4.2 s", durationText(4.2));
  EXPECT_EQ("3 min 05 s", durationText(185.0));
}

}  // namespace
}  // namespace sylph_rviz
