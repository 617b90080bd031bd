#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "execution_fixture.hpp"
#include "sylph_core/adg/alignment_room.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"

// Robots that stand off the middle of their start cells are aligned before a plan starts.

namespace sylph {
namespace {

constexpr double kDegree = M_PI / 180.0;

Footprint shippedRobot() {
  Footprint footprint;
  footprint.length_m = 0.23;
  footprint.width_m = 0.2;
  return footprint;
}

/// Two robots on the floor of execution_fixture.hpp.
class AlignmentRoomTest : public testing::Test {
 protected:
  AlignmentRoomTest() : frame_(test::kRows, test::kCellSize) {
    limits_.footprints = {shippedRobot(), shippedRobot()};
    limits_.obstacles = Grid(test::kRows, test::kCols);
    put(0, {2, 2});
  }

  void put(std::size_t robot, const Cell& cell, double x_m = 0.0, double y_m = 0.0,
           double yaw_deg = 0.0) {
    const Point center = frame_.toPoint(cell);
    question_.poses.resize(2);
    question_.poses[robot] = Pose2d{center.x + x_m, center.y + y_m, yaw_deg * kDegree};
    if (robot == 0) {
      question_.target = {center.x, center.y, 0.0};
    }
  }

  std::string reason() const {
    return reasonNotToAlign(question_, {"robot_0", "robot_1"}, frame_, limits_).value_or("");
  }

  CellFrame frame_;
  AlignmentLimits limits_;
  AlignmentQuestion question_;
};

TEST_F(AlignmentRoomTest, TurnsBesideARobotThatIsAligned) {
  put(0, {2, 2}, -0.02, -0.03, 26.0);
  put(1, {2, 3});
  EXPECT_EQ("", reason());
  put(0, {2, 2}, 0.02, -0.03, 26.0);
  EXPECT_EQ("", reason()) << "18 mm, but it moves away";
  put(0, {2, 2}, 0.025, -0.03, 26.0);
  EXPECT_NE("", reason()) << "13 mm";
}

TEST_F(AlignmentRoomTest, NotBesideOneThatIsTurnedTowardsIt) {
  put(0, {2, 2}, 0.02, 0.0, 26.0);
  put(1, {2, 3}, -0.02, 0.0, 26.0);
  EXPECT_EQ("would come within 0 mm of robot_1 while it is aligned: at least 30 are needed",
            reason());
}

TEST_F(AlignmentRoomTest, LooksAtTheWholeWay) {
  // Neither where it stands nor in the middle is it near the other one, but while it drives by.
  put(0, {2, 2}, 0.0, 0.14);
  put(1, {2, 3}, -0.05, -0.1);
  EXPECT_NE("", reason());
  question_.target.y_m -= 0.36;
  EXPECT_NE(std::string::npos, reason().find("within 20 mm of robot_1")) << reason();
}

TEST_F(AlignmentRoomTest, UnderWayHalfTheClearanceDoes) {
  put(0, {2, 2}, -0.02);
  put(1, {2, 3}, -0.045);
  EXPECT_NE("", reason());
  question_.is_under_way = true;
  EXPECT_EQ("", reason());
}

TEST_F(AlignmentRoomTest, ARobotWithoutAPoseIsNowhere) {
  put(0, {2, 2}, 0.02, 0.0, 26.0);
  question_.poses[1].reset();
  EXPECT_EQ("", reason());
}

TEST_F(AlignmentRoomTest, ComesNoNearerToAnObstacleThanItStands) {
  limits_.obstacles.setObstacle({2, 3});
  put(0, {2, 2}, 0.0, 0.0, 26.0);
  EXPECT_EQ("", reason()) << "it stands 3 mm from it and turns away";
  limits_.obstacles.setObstacle({1, 3});
  put(0, {1, 2}, -0.05, 0.0, -40.0);
  EXPECT_EQ("", reason());
  question_.target.x_m += 0.06;
  EXPECT_NE(std::string::npos, reason().find("of the obstacle at (1,3)")) << reason();
}

TEST_F(AlignmentRoomTest, ALargerTurnIsForTheOperator) {
  put(0, {2, 2}, 0.0, 0.0, -170.0);
  EXPECT_EQ("is turned by 170 deg, and at most 45 are aligned: turn it by hand", reason());
  put(0, {2, 2}, 0.0, 0.0, 44.0);
  EXPECT_EQ("", reason());
}

TEST(AlignmentLimitsTest, AreOfTheExperiment) {
  Experiment experiment;
  experiment.grid = Grid(2, 3);
  experiment.grid.setObstacle({0, 1});
  experiment.robots.resize(2);
  experiment.robots[1].length_m = 0.21;
  const AlignmentLimits limits = alignmentLimits(experiment);
  ASSERT_EQ(2U, limits.footprints.size());
  EXPECT_EQ(0.21, limits.footprints[1].length_m);
  EXPECT_FALSE(limits.obstacles.isFree({0, 1}));
  // 12 mm off, 0.5 rad/s at 0.152 m for 0.17 s, and half the promised separation.
  EXPECT_NEAR(0.030, limits.clearance_m, 0.003);
}

class AlignmentTest : public test::ExecutionTest {
 protected:
  AlignmentTest() {
    AlignmentLimits alignment;
    alignment.footprints.assign(3, shippedRobot());
    alignment.obstacles = Grid(test::kRows, test::kCols);
    limits_.alignment = std::make_shared<const AlignmentLimits>(alignment);
    restart();
    place(apart().front());
  }

  /// Each robot moves one cell east in a row of its own.
  static Plan apart() { return {{{0, 0}, {2, 0}, {4, 0}}, {{0, 1}, {2, 1}, {4, 1}}}; }

  void turn(int robot, double yaw_rad, double x_m = 0.0) {
    robots_[index(robot)].yaw_rad = yaw_rad;
    robots_[index(robot)].position.x += x_m;
    report(robot);
  }

  /// A robot does in one step what it is told: turned and in the middle, still on its way or not.
  void obey(int robot, RobotState state) {
    test::Robot& it = robots_[index(robot)];
    it.yaw_rad = 0.0;
    it.position = frame_.toPoint(frame_.toCell(it.position));
    it.state = state;
    report(robot);
  }
};

TEST_F(AlignmentTest, OneAfterTheOtherBeforeThePlanStarts) {
  turn(0, 0.4);
  turn(2, -0.3, 0.05);
  submit(apart(), 1);
  ASSERT_EQ(ExecutionPhase::Pending, execution_->phase()) << execution_->message();
  EXPECT_EQ(0, execution_->aligned());
  EXPECT_EQ("robot_0 is being aligned, 0 mm and 23 deg off", execution_->message());
  EXPECT_TRUE(view(0).is_aligning);
  EXPECT_FALSE(view(2).is_aligning);
  obey(0, RobotState::Moving);
  EXPECT_EQ(0, execution_->aligned()) << "it is there, but not yet at rest";
  obey(0, RobotState::Idle);
  EXPECT_EQ(2, execution_->aligned());
  obey(2, RobotState::Idle);
  EXPECT_EQ(std::nullopt, execution_->aligned());
  EXPECT_EQ(ExecutionPhase::Executing, execution_->phase());
}

TEST_F(AlignmentTest, NobodyIsAlignedWithoutTheOption) {
  limits_.alignment.reset();
  restart();
  place(apart().front());
  turn(0, 0.4);
  submit(apart(), 1);
  EXPECT_EQ(ExecutionPhase::Refused, execution_->phase());
}

TEST_F(AlignmentTest, ARobotInAnotherCellIsNotAligned) {
  turn(0, 0.4);
  turn(1, 0.0, 0.3);
  submit(apart(), 1);
  EXPECT_EQ(ExecutionPhase::Refused, execution_->phase());
  EXPECT_NE(std::string::npos, execution_->message().find("robot_1 is in (2,1)"));
  EXPECT_EQ(std::nullopt, execution_->aligned());
}

TEST_F(AlignmentTest, WaitsForTheOthersToRest) {
  turn(0, 0.4);
  robots_[1].state = RobotState::Moving;
  report(1);
  submit(apart(), 1);
  EXPECT_EQ(std::nullopt, execution_->aligned());
  EXPECT_EQ("robot_1 still moves", execution_->message());
  robots_[1].state = RobotState::Idle;
  report(1);
  EXPECT_EQ(0, execution_->aligned());
  robots_[1].state = RobotState::Blind;
  report(1);
  EXPECT_EQ(std::nullopt, execution_->aligned()) << "nobody knows where robot_1 is";
}

TEST_F(AlignmentTest, OnlyWhileRobotsMayRun) {
  turn(0, 0.4);
  submit(apart(), 1);
  execution_->setMode(ExecutionMode::Stop, "by the operator");
  step({0, 1, 2});
  EXPECT_EQ(std::nullopt, execution_->aligned());
  execution_->setMode(ExecutionMode::Run, "");
  reportAll();
  step({0, 1, 2});
  EXPECT_EQ(0, execution_->aligned());
}

TEST_F(AlignmentTest, IsRefusedIfItDoesNotSucceed) {
  turn(0, 0.4);
  submit(apart(), 1);
  robots_[0].state = RobotState::Holding;
  robots_[0].detail = "its base is dead";
  for (double waited_s = 0.0; waited_s <= limits_.start_wait_s + 1.0; waited_s += 0.5) {
    now_s_ += 0.5;
    reportAll();
  }
  EXPECT_EQ(ExecutionPhase::Refused, execution_->phase());
  EXPECT_EQ("plan 1: robot_0 is being aligned, 0 mm and 23 deg off: its base is dead",
            execution_->message());
  EXPECT_EQ(std::nullopt, execution_->aligned());
}

TEST_F(AlignmentTest, IsRefusedWithoutRoom) {
  const Plan side_by_side = {{{0, 0}, {0, 1}, {4, 0}}, {{1, 0}, {1, 1}, {4, 1}}};
  place(side_by_side.front());
  turn(0, 0.4, 0.03);
  turn(1, 0.4);
  submit(side_by_side, 1);
  EXPECT_EQ(ExecutionPhase::Refused, execution_->phase());
  EXPECT_NE(std::string::npos, execution_->message().find("robot_0 would come within"));
  EXPECT_NE(std::string::npos, execution_->message().find("robot_1 would come within"));
}

TEST_F(AlignmentTest, WhoHasRoomGoesFirst) {
  // robot_1 stands where robot_0 has to go by.
  const Plan side_by_side = {{{0, 0}, {0, 1}, {4, 0}}, {{1, 0}, {1, 1}, {4, 1}}};
  place(side_by_side.front());
  turn(0, 0.0, -0.05);
  turn(1, 0.0, -0.05);
  submit(side_by_side, 1);
  ASSERT_EQ(1, execution_->aligned()) << execution_->message();
  obey(1, RobotState::Idle);
  EXPECT_EQ(0, execution_->aligned()) << execution_->message();
}

}  // namespace
}  // namespace sylph
