#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "robot_world.hpp"
#include "sylph_core/control/robot_controller.hpp"

namespace sylph {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(RobotControllerTest, MakesUpForSlip) {
  RobotWorld world({2, 0});
  world.grip = 0.93;
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.5);
  const double x_m = world.x();
  world.run(1.0);
  EXPECT_NEAR(0.25, world.x() - x_m, 0.003);
}

TEST(RobotControllerTest, RampsToZeroWithoutPosesAndGoesOnByItself) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.cameras_send = false;
  world.run(0.1);
  EXPECT_GT(world.speedNow(), 0.2);
  world.run(0.06);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.run(0.25);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.cameras_send = true;
  world.run(4.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, APoseThatIsNotFiniteStopsIt) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.camera_offset.x_m = kNaN;
  world.run(0.4);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_EQ("pose is not finite", world.report().detail);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
}

TEST(RobotControllerTest, ARobotCarriedAwayHoldsUntilItIsPutBack) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(1.0);
  world.loseSightFor(0.3);
  world.camera_offset.y_m = 0.5;
  world.run(0.5);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_TRUE(world.stopConfirmAndResume().is_confirmed);
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_NE(std::string::npos, world.report().detail.find("put it back"));
  world.loseSightFor(0.3);
  world.camera_offset.y_m = 0.0;
  world.run(0.3);
  EXPECT_TRUE(world.stopConfirmAndResume().is_confirmed);
  world.run(4.0);
  EXPECT_EQ(2, world.report().done);
}

TEST(RobotControllerTest, AJumpOfThePoseIsBelievedOnlyWhenTheOperatorConfirmsIt) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(1.0);
  world.camera_offset.x_m = 0.1;
  world.run(2.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.stopAndResume();  // for another robot's sake
  EXPECT_EQ(RobotState::Blind, world.report().state);
  const PoseConfirmation confirmation = world.stopConfirmAndResume();
  EXPECT_TRUE(confirmation.is_confirmed);
  EXPECT_NE(std::string::npos, confirmation.message.find("0 deg, in (2,1)"))
      << confirmation.message;
  EXPECT_EQ(RobotState::Moving, world.report().state);
}

TEST(RobotControllerTest, AnOperatorConfirmsOnlyWhatThereIsAndWhileAllAreStopped) {
  RobotWorld world({2, 0});
  EXPECT_EQ("stop first: a robot whose pose is confirmed may drive on at once",
            world.controller.confirmPose(world.now_s).message);
  world.run(0.2);
  world.sendEastward(4);
  world.run(1.0);
  EXPECT_EQ("nothing is wrong with its pose", world.stopConfirmAndResume().message);
  world.camera_offset.x_m = 0.1;
  world.run(1.0);
  EXPECT_FALSE(world.controller.confirmPose(world.now_s).is_confirmed);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.loseSightFor(0.2);
  world.camera_offset.x_m = -0.2;
  world.mode = ExecutionMode::Stop;
  world.run(0.1);  // not long enough there
  EXPECT_EQ(0U, world.controller.confirmPose(world.now_s).message.find("there is no pose"));
  EXPECT_FALSE(world.controller.placeToConfirm());
  world.run(0.1);
  EXPECT_TRUE(world.controller.placeToConfirm());
  EXPECT_TRUE(world.controller.confirmPose(world.now_s).is_confirmed);
}

TEST(RobotControllerTest, ARobotWithoutATaskIsWherePeoplePutIt) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.loseSightFor(0.5);
  world.pose.x_m += 0.3;
  world.run(0.3);
  EXPECT_EQ(RobotState::Idle, world.report().state);
  EXPECT_NEAR(0.45, world.report().pose->x_m, 0.01);
}

TEST(RobotControllerTest, AJumpIsNotBelievedBecauseTheBaseDroveLessThanItsModel) {
  for (const double grip : {0.8, 0.9, 1.0}) {
    SCOPED_TRACE(grip);
    RobotWorld world({2, 0});
    world.run(0.2);
    world.sendEastward(4);
    world.run(0.8);
    world.grip = grip;
    world.camera_offset.x_m = 0.031;
    world.run(1.5);
    EXPECT_EQ(RobotState::Blind, world.report().state);
    world.grip = 1.0;
    world.camera_offset.x_m = 0.0;
    world.run(7.0);
    EXPECT_EQ(4, world.report().done);
  }
}

TEST(RobotControllerTest, NobodyPutsARobotElsewhereInOneStep) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.camera_offset.x_m = 0.0309;
  world.run(1.2);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_NEAR(0.15, world.report().pose->x_m, 0.001);
  world.camera_offset.x_m = 0.0;
  world.run(0.2);
  EXPECT_EQ(RobotState::Idle, world.report().state);
}

TEST(RobotControllerTest, ARobotThatIsSeenOnItsWayWasCarried) {
  RobotWorld world({2, 0});
  world.run(0.2);
  for (int k = 0; k < 10; ++k) {
    world.pose.x_m += 0.03;  // 3 m/s
    world.run(0.01);
  }
  world.run(0.3);
  EXPECT_EQ(RobotState::Idle, world.report().state);
  EXPECT_NEAR(0.45, world.report().pose->x_m, 0.01);
}

TEST(RobotControllerTest, ARobotThatIsAboutToDriveIsWhereItWasSeen) {
  RobotWorld world({2, 0});
  world.has_tasks_to_come = true;
  world.run(0.2);
  world.camera_offset.y_m = 0.065;
  world.run(1.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.sendEastward(4);
  world.run(1.0);
  EXPECT_NEAR(0.15, world.x(), 0.001) << "its place is not known";
  world.camera_offset.y_m = 0.0;
  world.run(0.5);
  world.sendEastward(4);  // as the central node does until the robot confirms
  world.run(8.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, AFalsePlaceAfterAShortOcclusionMovesNoRobot) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(2.0);
  world.loseSightFor(0.12);
  world.camera_offset.y_m = 0.1;
  world.run(3.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_NEAR(0.75, world.pose.y_m, 0.005);
  world.camera_offset.y_m = 0.0;
  world.run(5.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, AJumpBackAlongTheWayOfBrakingIsNotBelieved) {
  for (const double back_m : {0.035, 0.045, 0.06, 0.09}) {
    SCOPED_TRACE(back_m);
    RobotWorld world({2, 0});
    world.run(0.2);
    world.sendEastward(4);
    world.run(2.0);
    world.camera_offset.x_m = -back_m;
    world.run(2.5);
    EXPECT_EQ(RobotState::Blind, world.report().state);
    EXPECT_DOUBLE_EQ(0.0, world.speedNow());
    world.camera_offset.x_m = 0.0;
    world.run(5.0);
    EXPECT_EQ(4, world.report().done);
    EXPECT_NEAR(1.35, world.x(), 0.005);
  }
}

TEST(RobotControllerTest, ABodyWithTurnedAxesStopsItSoon) {
  RobotWorld world({2, 1});
  world.run(0.2);
  for (int k = 0; k < 3; ++k) {
    world.controller.onTask({1, k, {2, k + 1}, {2, k + 2}}, world.now_s);
  }
  world.grip = -1.0;
  world.run(5.0);
  EXPECT_NE(std::string::npos, world.report().detail.find("exchanged or turned"))
      << world.report().detail;
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  EXPECT_LT(std::abs(world.x() - 0.45), 0.067);  // what lies between two robots in the lab
}

TEST(RobotControllerTest, ARobotWithTheBodyOfOneThatStandsIsSoonDrivenNoMore) {
  RobotWorld world({4, 4});
  world.other_body = Pose2d{0.15, 0.75, 0.0};  // in (2,0)
  world.run(0.2);
  world.sendEastward(4);
  world.run(12.0);
  EXPECT_NE(std::string::npos, world.report().detail.find("bodies exchanged"))
      << world.report().detail;
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  EXPECT_LT(world.x() - 1.35, 0.15);  // 3.1 m, if nobody looks
}

TEST(RobotControllerTest, APoseThatSlidesAwayIsNotFollowed) {
  for (const double slide_mps : {0.1, 0.3}) {
    SCOPED_TRACE(slide_mps);
    RobotWorld world({2, 0});
    world.run(0.2);
    world.sendEastward(1);
    world.run(4.0);
    ASSERT_EQ(1, world.report().done);
    for (double slid_m = 0.0; slid_m < 0.12; slid_m += 0.01 * slide_mps) {
      world.camera_offset.y_m = slid_m;
      world.run(0.01);
    }
    world.run(3.0);
    EXPECT_NE(std::string::npos, world.report().detail.find("otherwise than it is driven"))
        << world.report().detail;
    EXPECT_NEAR(0.75, world.pose.y_m, 0.067);
  }
}

TEST(RobotControllerTest, ABaseThatIsStuckForThreeSecondsGoesOnByItself) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.run(1.0);
  world.grip = 0.0;
  world.run(3.0);
  world.grip = 1.0;
  world.run(8.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, ABaseThatNeverAnswersIsCommandedNoMore) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(4);
  world.grip = 0.0;
  world.run(6.0);
  EXPECT_NE(std::string::npos, world.report().detail.find("base dead")) << world.report().detail;
  EXPECT_DOUBLE_EQ(0.0, world.speedNow());
  world.grip = 1.0;
  world.stopAndResume();  // for another robot's sake
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_EQ("it is confirmed that its pose moves as it is driven",
            world.stopConfirmAndResume().message);
  world.run(8.0);
  EXPECT_EQ(4, world.report().done);
}

TEST(RobotControllerTest, ARobotPushedWithinItsCellsReturnsToItsPath) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(1);
  world.run(0.5);
  world.loseSightFor(0.2);
  world.pose.y_m += 0.08;
  world.run(0.3);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  world.stopConfirmAndResume();
  world.run(4.0);
  EXPECT_EQ(1, world.report().done);
  EXPECT_LT(world.report().tracking_error_m, 0.01);
}

TEST(RobotControllerTest, AYawFlipNeverTurnsTheRobot) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(0.5);
  world.camera_offset.yaw_rad = M_PI;
  world.run(2.0);
  EXPECT_EQ(RobotState::Blind, world.report().state);
  EXPECT_DOUBLE_EQ(0.0, world.command_robot.turn_radps);
  world.camera_offset.yaw_rad = 0.0;
  world.run(4.0);
  EXPECT_EQ(2, world.report().done);
}

TEST(RobotControllerTest, ARobotThatWasTurnedByHandWaitsToBeTurnedBack) {
  RobotWorld world({2, 0});
  world.run(0.2);
  world.sendEastward(2);
  world.run(0.5);
  world.loseSightFor(0.3);
  world.camera_offset.yaw_rad = 1.5;
  world.run(1.0);
  world.stopConfirmAndResume();
  EXPECT_EQ(RobotState::Holding, world.report().state);
  EXPECT_NE(std::string::npos, world.report().detail.find("heading"));
  EXPECT_DOUBLE_EQ(0.0, world.command_robot.turn_radps);
  world.loseSightFor(0.3);
  world.camera_offset.yaw_rad = 0.0;
  world.run(0.3);
  world.stopConfirmAndResume();
  world.run(4.0);
  EXPECT_EQ(2, world.report().done);
}

}  // namespace
}  // namespace sylph
