#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot_world.hpp"

// How a robot is aligned before its plan begins: turned to its heading and driven to the middle of
// its cell.

namespace sylph {
namespace {

constexpr double kTurned = 0.45;  // 26 deg: more than a robot corrects by itself

/// A robot that stands turned and off the centre of (2,0).
class RobotAlignmentTest : public testing::Test {
 protected:
  RobotAlignmentTest() : world_({2, 0}) {
    world_.pose.x_m += 0.06;
    world_.pose.y_m -= 0.03;
    world_.pose.yaw_rad = kTurned;
    world_.run(0.2);
  }

  /// The operator puts it there, whose hands hide it meanwhile.
  void put(const Pose2d& pose) {
    world_.loseSightFor(0.3);
    world_.pose = pose;
    world_.run(0.3);
  }

  double offset() const { return distance(world_.frame.toPoint({2, 0}), position(world_.pose)); }

  RobotWorld world_;
};

TEST_F(RobotAlignmentTest, TurnsAndDrivesToTheMiddleOfItsCell) {
  world_.is_aligning = true;
  world_.run(1.0);
  EXPECT_EQ(RobotState::Moving, world_.report().state);
  world_.run(7.0);
  EXPECT_EQ(RobotState::Idle, world_.report().state);
  EXPECT_LT(offset(), 0.010);
  EXPECT_NEAR(0.0, world_.pose.yaw_rad, 0.05);
}

TEST_F(RobotAlignmentTest, TurnsBeforeItDrivesAndDrivesSlowly) {
  world_.is_aligning = true;
  const double before_m = offset();
  double fastest_mps = 0.0;
  while (std::abs(world_.pose.yaw_rad) > 0.06) {
    world_.run(0.02);
    ASSERT_NEAR(before_m, offset(), 0.001);
  }
  for (int k = 0; k < 250; ++k) {
    world_.run(0.02);
    fastest_mps = std::max(fastest_mps, world_.speedNow());
  }
  EXPECT_LT(offset(), 0.010);
  EXPECT_GT(fastest_mps, 0.02);
  EXPECT_LT(fastest_mps, 0.04);
}

TEST_F(RobotAlignmentTest, DoesNotMoveByItself) {
  world_.run(2.0);
  EXPECT_EQ(kTurned, world_.pose.yaw_rad);
}

TEST_F(RobotAlignmentTest, StopsWhenTheCentralNodeNoLongerWantsIt) {
  world_.is_aligning = true;
  world_.run(0.5);
  world_.is_aligning = false;
  world_.run(0.3);
  const double yaw_rad = world_.pose.yaw_rad;
  EXPECT_GT(yaw_rad, 0.1);
  world_.run(1.0);
  EXPECT_EQ(yaw_rad, world_.pose.yaw_rad);
  EXPECT_EQ(RobotState::Idle, world_.report().state);
}

TEST_F(RobotAlignmentTest, HoldsWithoutTheCentralNodeAndWhenStopped) {
  world_.is_aligning = true;
  world_.run(0.3);
  world_.central_sends = false;
  world_.run(1.0);
  EXPECT_EQ(RobotState::Holding, world_.report().state);
  EXPECT_NE(std::string::npos, world_.report().detail.find("central node silent"));
  world_.central_sends = true;
  world_.mode = ExecutionMode::Stop;
  world_.run(0.5);
  const double yaw_rad = world_.pose.yaw_rad;
  EXPECT_GT(yaw_rad, 0.1);
  world_.run(1.0);
  EXPECT_EQ(yaw_rad, world_.pose.yaw_rad);
  world_.mode = ExecutionMode::Run;
  world_.run(8.0);
  EXPECT_LT(offset(), 0.010);
}

TEST_F(RobotAlignmentTest, StopsIfItsBaseDoesNotAnswer) {
  put({world_.pose.x_m, world_.pose.y_m, 0.0});
  world_.grip = 0.0;
  world_.is_aligning = true;
  world_.run(10.0);
  EXPECT_EQ(RobotState::Holding, world_.report().state);
  EXPECT_NE(std::string::npos, world_.report().detail.find("its pose does not follow"));
}

TEST_F(RobotAlignmentTest, StopsSoonIfItsPoseIsThatOfAnotherBody) {
  const Pose2d start = world_.pose;
  world_.other_body = world_.pose;
  world_.is_aligning = true;
  world_.run(10.0);
  EXPECT_EQ(RobotState::Holding, world_.report().state);
  EXPECT_LT(std::abs(shortestAngle(start.yaw_rad, world_.pose.yaw_rad)), 0.3);
  world_.is_aligning = false;
  world_.run(0.5);
  world_.loseSightFor(0.3);
  world_.other_body->yaw_rad = 0.0;
  world_.run(0.3);
  world_.is_aligning = true;
  world_.run(10.0);
  EXPECT_EQ(RobotState::Holding, world_.report().state);
  EXPECT_LT(distance(position(start), position(world_.pose)), 0.025);
}

TEST_F(RobotAlignmentTest, CarriesOutItsTasksAfterwards) {
  world_.is_aligning = true;
  world_.run(8.0);
  // The first task may be faster than the news that the alignment is over.
  world_.sendEastward(2);
  world_.run(4.0);
  EXPECT_EQ(2, world_.report().done);
  EXPECT_NEAR(0.75, world_.x(), 0.01);
}

TEST_F(RobotAlignmentTest, LeavesARobotWithTasksToThem) {
  put({world_.frame.toPoint({2, 0}).x, world_.frame.toPoint({2, 0}).y, 0.0});
  world_.sendEastward(2);
  world_.is_aligning = true;
  world_.run(4.0);
  EXPECT_EQ(2, world_.report().done);
}

TEST_F(RobotAlignmentTest, IsAlignedWhereItWasCarriedAfterAMission) {
  put({world_.frame.toPoint({2, 0}).x, world_.frame.toPoint({2, 0}).y, 0.0});
  world_.sendEastward(1);
  world_.run(3.0);
  ASSERT_EQ(1, world_.report().done);
  world_.pose = {world_.frame.toPoint({4, 4}).x + 0.05, world_.frame.toPoint({4, 4}).y, 0.3};
  EXPECT_TRUE(world_.stopConfirmAndResume().is_confirmed);
  EXPECT_NE(std::string::npos, world_.report().detail.find("put it back"));
  world_.is_aligning = true;
  world_.run(8.0);
  EXPECT_LT(distance(world_.frame.toPoint({4, 4}), position(world_.pose)), 0.010);
}

}  // namespace
}  // namespace sylph
