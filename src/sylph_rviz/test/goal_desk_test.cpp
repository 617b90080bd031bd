#include "sylph_rviz/goal_desk.hpp"

#include <gtest/gtest.h>

#include "mission/small_lab.hpp"
#include "test_scene.hpp"

namespace sylph_rviz {
namespace {

/// A desk in the small lab, see GoalDraftTest.
class GoalDeskTest : public ::testing::Test {
 protected:
  GoalDeskTest() { desk.setLab(sylph::smallLab()); }
  static sylph::Point at(const sylph::Cell& cell) {
    return cellFrameOf(sylph::smallLab()).toPoint(cell);
  }
  static sylph_msgs::ExecuteMissionResult result(std::uint32_t shown_plan,
                                                 const std::string& message) {
    sylph_msgs::ExecuteMissionResult result;
    result.shown_plan_id = shown_plan;
    result.message = message;
    return result;
  }

  sylph::RobotPoses poses = sylph::posesInStarts();
  GoalDesk desk;
};

TEST_F(GoalDeskTest, LeadsFromAGoalByThePlanToTheMission) {
  EXPECT_EQ("no goal is set: drag a robot's, or use 2D Nav Goal for the selected robot",
            desk.plan());
  EXPECT_EQ("robot_0 to (0,2)", desk.set("robot_0", at({0, 2}), poses));
  EXPECT_EQ("", desk.plan());
  EXPECT_EQ("plan first", desk.go());
  desk.onSent();
  EXPECT_EQ("it is being planned", desk.plan());
  EXPECT_EQ("it is being planned", desk.go());
  desk.onPlanned(result(3, "2 steps, checked"));
  EXPECT_EQ("", desk.go());
  EXPECT_EQ(3U, desk.shownPlan());
  EXPECT_EQ("robot_0 to (0,2); 2 robots stay\nplan 3: 2 steps, checked", desk.text());
}

TEST_F(GoalDeskTest, APlanIsOfTheGoalsThatItWasMadeOf) {
  desk.set("robot_0", at({0, 2}), poses);
  desk.onSent();
  desk.onPlanned(result(3, "2 steps, checked"));
  desk.set("robot_1", at({2, 0}), poses);
  EXPECT_EQ(0U, desk.shownPlan());
  EXPECT_EQ("the goals have changed: plan again", desk.go());
  EXPECT_EQ("robot_1 stays", desk.set("robot_1", at({2, 4}), poses));
  EXPECT_EQ("", desk.go()) << "the same goals again";
  desk.setOthersGiveWay(true);
  EXPECT_EQ("the goals have changed: plan again", desk.go());
}

TEST_F(GoalDeskTest, TellsWhyThereIsNoPlan) {
  desk.set("robot_0", at({0, 2}), poses);
  desk.onSent();
  desk.onPlanned(result(0, "none found within 0.2 s"));
  EXPECT_EQ("there is no plan: none found within 0.2 s", desk.go());
  EXPECT_EQ("robot_0 to (0,2); 2 robots stay\nno plan: none found within 0.2 s", desk.text());
}

TEST_F(GoalDeskTest, WithoutALabNothingCanBePlanned) {
  desk.set("robot_0", at({0, 2}), poses);
  desk.setLab(std::nullopt);
  EXPECT_EQ("the lab's experiment is not known here", desk.plan());
  EXPECT_EQ("", desk.text());
}

TEST_F(GoalDeskTest, DrawsGoalsAndWhyTheOneThatIsDraggedIsRefused) {
  Scene scene = twoRobots();
  desk.set("robot_0", at({0, 2}), poses);
  EXPECT_NE(nullptr, findMarker(desk.markers(scene), "goal", 0));
  desk.drag("robot_0", at({0, 1}), poses);
  EXPECT_EQ(nullptr, findMarker(desk.markers(scene), "goal", 0)) << "it is in the hand";
  EXPECT_NE(nullptr, findMarker(desk.markers(scene), "hover", 0));
  EXPECT_EQ(nullptr, findMarker(desk.markers(scene), "hover_cross", 0));
  desk.drag("robot_0", at({0, 4}), poses);
  ASSERT_NE(nullptr, findMarker(desk.markers(scene), "hover_text", 0));
  EXPECT_EQ("goal (0,4) of robot_0 is where",
            findMarker(desk.markers(scene), "hover_text", 0)->text);
  desk.set("robot_0", at({0, 4}), poses);
  EXPECT_EQ(nullptr, findMarker(desk.markers(scene), "hover", 0));
  EXPECT_EQ((sylph::Cell{0, 2}), desk.draft()->goals().at("robot_0"));
}

}  // namespace
}  // namespace sylph_rviz
