#include "sylph_core/control/robot_supervisor.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sylph {
namespace {

RobotSituation driving() {
  RobotSituation situation;
  situation.has_task = true;
  situation.central_silence_s = 0.1;
  return situation;
}

RobotDecision decideAbout(const RobotSituation& situation) {
  return decide(situation, SupervisorLimits{});
}

void expectStop(const RobotSituation& situation, RobotState state, const std::string& detail) {
  const RobotDecision decision = decideAbout(situation);
  EXPECT_EQ(Permission::Stop, decision.permission);
  EXPECT_EQ(state, decision.state);
  EXPECT_NE(std::string::npos, decision.detail.find(detail)) << decision.detail;
}

TEST(RobotSupervisorTest, DrivesWhenAllIsWell) {
  const RobotDecision decision = decideAbout(driving());
  EXPECT_EQ(Permission::Drive, decision.permission);
  EXPECT_EQ(RobotState::Moving, decision.state);
  EXPECT_EQ("", decision.detail);
}

TEST(RobotSupervisorTest, KeepsItsPlaceWithoutATask) {
  RobotSituation situation = driving();
  situation.has_task = false;
  EXPECT_EQ(Permission::Drive, decideAbout(situation).permission);
  EXPECT_EQ(RobotState::Idle, decideAbout(situation).state);
}

TEST(RobotSupervisorTest, StopsBlind) {
  RobotSituation situation = driving();
  situation.pose_problem = "pose is not finite";
  expectStop(situation, RobotState::Blind, "pose is not finite");
}

TEST(RobotSupervisorTest, DoesNotMoveBeforeTheCentralNodeIsHeard) {
  RobotSituation situation = driving();
  situation.central_silence_s.reset();
  expectStop(situation, RobotState::Holding, "not heard yet");
}

TEST(RobotSupervisorTest, StopsWhenToldTo) {
  RobotSituation situation = driving();
  situation.mode = ExecutionMode::Stop;
  expectStop(situation, RobotState::Holding, "stopped by the central node");
}

TEST(RobotSupervisorTest, APauseLetsItFinishWhatItHas) {
  RobotSituation situation = driving();
  situation.mode = ExecutionMode::Pause;
  EXPECT_EQ(Permission::Drive, decideAbout(situation).permission);
}

TEST(RobotSupervisorTest, AnEmergencyStopsWhateverTheCentralNodeSays) {
  RobotSituation situation = driving();
  situation.is_emergency = true;
  expectStop(situation, RobotState::Holding, "emergency stop");
}

TEST(RobotSupervisorTest, FinishesItsTaskWhenTheCentralNodeFallsSilentThenHolds) {
  RobotSituation situation = driving();
  situation.central_silence_s = 0.6;
  EXPECT_EQ(Permission::FinishTask, decideAbout(situation).permission);
  EXPECT_EQ(RobotState::Moving, decideAbout(situation).state);
  situation.has_finished_last_task = true;
  expectStop(situation, RobotState::Holding, "silent for 0.6 s");
}

TEST(RobotSupervisorTest, AStopOutlastsTheSilenceOfTheCentralNode) {
  RobotSituation situation = driving();
  situation.mode = ExecutionMode::Stop;
  situation.central_silence_s = 10.0;
  expectStop(situation, RobotState::Holding, "stopped");
}

TEST(RobotSupervisorTest, ADisplacedRobotWaitsForTheOperator) {
  RobotSituation situation = driving();
  situation.is_displaced = true;
  expectStop(situation, RobotState::Holding, "outside the cells");
}

TEST(RobotSupervisorTest, ATurnedRobotWaitsForTheOperator) {
  RobotSituation situation = driving();
  situation.heading_error_rad = -1.5708;
  expectStop(situation, RobotState::Holding, "heading is 90 deg off: turn it by hand");
  situation.heading_error_rad = 0.2;
  EXPECT_EQ(Permission::Drive, decideAbout(situation).permission);
}

TEST(EmergencyLatchTest, EndsOnlyByStopAndResume) {
  EmergencyLatch latch;
  EXPECT_FALSE(latch.isActive());
  latch.onCentralMode(ExecutionMode::Run);
  latch.onEmergencyStop(true);
  EXPECT_TRUE(latch.isActive());
  latch.onEmergencyStop(false);
  latch.onCentralMode(ExecutionMode::Run);  // sent before the central node knew
  EXPECT_TRUE(latch.isActive());
  latch.onCentralMode(ExecutionMode::Stop);
  EXPECT_TRUE(latch.isActive());
  latch.onCentralMode(ExecutionMode::Run);
  EXPECT_FALSE(latch.isActive());
}

TEST(EmergencyLatchTest, AResumeBeforeTheStopIsOverDoesNotCount) {
  EmergencyLatch latch;
  latch.onEmergencyStop(true);
  latch.onCentralMode(ExecutionMode::Stop);
  latch.onCentralMode(ExecutionMode::Run);
  EXPECT_TRUE(latch.isActive());
  latch.onEmergencyStop(false);
  EXPECT_TRUE(latch.isActive());
  latch.onCentralMode(ExecutionMode::Run);
  EXPECT_FALSE(latch.isActive());
}

}  // namespace
}  // namespace sylph
