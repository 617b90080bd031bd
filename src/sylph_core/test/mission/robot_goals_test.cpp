#include "sylph_core/mission/robot_goals.hpp"

#include <gtest/gtest.h>

#include "small_lab.hpp"

namespace sylph {
namespace {

const RobotGoals kGoals = {{"robot_1", {1, 0}}};

TEST(WithGoalsTest, LetsRobotsWithoutGoalStay) {
  const Configuration cells = {{0, 1}, {2, 3}, {0, 4}};
  const Experiment mission = withGoals(smallLab(), kGoals, cells);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cells[i], mission.robots[i].start);
  }
  EXPECT_EQ((Cell{0, 1}), mission.robots[0].goal);
  EXPECT_EQ((Cell{1, 0}), mission.robots[1].goal);
}

TEST(WithParticipantsTest, GivesPartToOthersOnlyIfTheyGiveWay) {
  const Experiment mission = withGoals(smallLab(), kGoals, smallStarts());
  EXPECT_EQ(std::vector<std::string>{"robot_1"}, namesOf(withParticipants(mission, kGoals, false)));
  EXPECT_EQ(namesOf(smallLab()), namesOf(withParticipants(mission, kGoals, true)));
}

TEST(HeadlineOfTest, SaysWhoGoesAndWhoStays) {
  EXPECT_EQ("robot_1 to (1,0); 2 robots stay", headlineOf(kGoals, 3, false));
  const RobotGoals two = {{"robot_1", {1, 0}}, {"robot_2", {0, 0}}};
  EXPECT_EQ("robot_1 to (1,0), robot_2 to (0,0); 1 robot stays", headlineOf(two, 3, false));
  EXPECT_EQ("robot_1 to (1,0), robot_2 to (0,0); 1 robot may give way", headlineOf(two, 3, true));
}

}  // namespace
}  // namespace sylph
