#include "sylph_rviz/goal_draft.hpp"

#include <gtest/gtest.h>

#include "mission/small_lab.hpp"

namespace sylph_rviz {
namespace {

/// The small lab with its robots in the middle of their starts: (0,0), (2,4) and (0,4).
///     0...2
///     .@@..
///     ....1
class GoalDraftTest : public ::testing::Test {
 protected:
  static sylph::Point at(const sylph::Cell& cell) {
    return cellFrameOf(sylph::smallLab()).toPoint(cell);
  }
  std::string refusal(const std::string& robot, const sylph::Cell& cell) {
    return draft.set(robot, at(cell), poses).refusal;
  }

  sylph::RobotPoses poses = sylph::posesInStarts();
  GoalDraft draft{sylph::smallLab()};
};

TEST_F(GoalDraftTest, SnapsToTheFreeCellNextToThePoint) {
  const sylph::Point beside = at({0, 2}) + sylph::Vector2{0.1, -0.12};
  EXPECT_EQ((sylph::Cell{0, 2}), draft.set("robot_0", beside, poses).cell);
  const sylph::Point in_the_wall = at({1, 2}) + sylph::Vector2{0.02, -0.1};
  EXPECT_EQ((sylph::Cell{2, 2}), draft.set("robot_0", in_the_wall, poses).cell);
  EXPECT_EQ((sylph::RobotGoals{{"robot_0", {2, 2}}}), draft.goals());
  EXPECT_EQ("robot_0 to (2,2); 2 robots stay", draft.headline());
}

TEST_F(GoalDraftTest, RefusesWhatIsTakenAndKeepsTheGoalBefore) {
  ASSERT_EQ("", refusal("robot_0", {0, 2}));
  EXPECT_EQ("goal (0,4) of robot_0 is where robot_2 stands, which has no part in the mission",
            refusal("robot_0", {0, 4}));
  EXPECT_EQ("goal (0,2) of robot_1 is also the goal of robot_0", refusal("robot_1", {0, 2}));
  EXPECT_EQ("goal (3,0) of robot_0 lies outside the map of 3 x 5 cells",
            refusal("robot_0", {3, 0}));
  EXPECT_EQ((sylph::RobotGoals{{"robot_0", {0, 2}}}), draft.goals());
}

TEST_F(GoalDraftTest, RefusesWhatIsOutOfReachPastRobotsThatStay) {
  poses["robot_2"] = {sylph::pose2dIn(sylph::smallMission(), {0, 1}), {}};
  poses["robot_1"] = {sylph::pose2dIn(sylph::smallMission(), {2, 1}), {}};
  EXPECT_EQ(
      "goal (0,4) of robot_0 cannot be reached from its cell (0,0) past robots without part in the "
      "mission: robot_1, robot_2",
      refusal("robot_0", {0, 4}));
  draft.setOthersGiveWay(true);
  EXPECT_EQ("", refusal("robot_0", {0, 4}));
  EXPECT_EQ("goal (0,1) of robot_0 is also the goal of robot_2", refusal("robot_0", {0, 1}))
      << "robot_2 comes back to it";
}

TEST_F(GoalDraftTest, TheRobotsOwnCellTakesItsGoalBackUnlessAnotherWantsIt) {
  ASSERT_EQ("", refusal("robot_2", {0, 2}));
  EXPECT_EQ("", refusal("robot_2", {0, 4}));
  EXPECT_TRUE(draft.goals().empty());
  ASSERT_EQ("", refusal("robot_2", {0, 2}));
  ASSERT_EQ("", refusal("robot_0", {0, 4}));
  EXPECT_EQ("goal (0,4) of robot_2 is also the goal of robot_0", refusal("robot_2", {0, 4}));
}

TEST_F(GoalDraftTest, MakesAMissionOfThoseThatHaveAGoal) {
  ASSERT_EQ("", refusal("robot_1", {2, 0}));
  EXPECT_EQ(std::vector<std::string>{"robot_1"}, namesOf(draft.mission(poses)));
  const sylph::Experiment experiment = draft.experiment(poses);
  ASSERT_EQ(3U, experiment.robots.size());
  EXPECT_EQ((sylph::Cell{0, 0}), experiment.robots[0].goal) << "it stays";
  EXPECT_EQ((sylph::Cell{2, 0}), experiment.robots[1].goal);
  draft.setOthersGiveWay(true);
  EXPECT_EQ(3U, draft.mission(poses).robots.size());
  poses.erase("robot_0");
  draft.setOthersGiveWay(false);
  EXPECT_EQ(std::vector<std::string>{"robot_1"}, namesOf(draft.mission(poses)))
      << "the planner decides whether it goes on without robot_0";
  draft.setOthersGiveWay(true);
  EXPECT_EQ("2: no pose of robot_0 has come", sylph::failureOf([this] { draft.mission(poses); }));
}

}  // namespace
}  // namespace sylph_rviz
