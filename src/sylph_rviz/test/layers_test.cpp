#include "sylph_rviz/layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "sylph_rviz/palette.hpp"
#include "test_scene.hpp"

namespace sylph_rviz {
namespace {

/// A fingerprint of a badge's sign: form and number of points.
std::tuple<int, std::size_t> signOf(RobotStatus status) {
  const Markers badge = statusBadge("badge", 0, status, 2);
  return {badge.back().type, badge.back().points.size()};
}

/// robot_1 goes from (3,4) to (3,3).
sylph::MissionPlan planOfOneMove() {
  sylph::MissionPlan plan;
  plan.plan_id = 1;
  plan.robots = {"robot_1"};
  plan.goals = {{3, 3}};
  plan.plan = {{{3, 4}}, {{3, 3}}};
  return plan;
}

TEST(LayersTest, GiveEachMarkerAnIdOfItsOwn) {
  Scene scene = twoRobots();
  scene.robots[0].execution->waiting = 1;
  scene.robots[0].execution->waits_for_robot = "robot_1";
  scene.robots[0].execution->root_cause_robot = "robot_1";
  scene.selected = "robot_0";
  scene.state->phase = sylph_msgs::AdgState::FINISHED;
  scene.shown_plan = planOfOneMove();
  for (const Layer& layer : kLayers) {
    std::set<std::pair<std::string, int>> ids;
    const Markers markers = layer.draw(scene);
    EXPECT_FALSE(markers.empty()) << layer.topic;
    for (const Marker& marker : markers) {
      EXPECT_TRUE(ids.emplace(marker.ns, marker.id).second)
          << layer.topic << " " << marker.ns << " " << marker.id;
    }
  }
}

TEST(LayersTest, ShowFirstInACrowdWhomTheOperatorLooksFor) {
  Scene scene = twoRobots();
  EXPECT_EQ((std::vector<bool>{true, true}), inFront(scene)) << "two are no crowd";
  while (scene.robots.size() < kCrowd + 1) {
    scene.robots.push_back(scene.robots[0]);
    scene.robots.back().name = "robot_" + std::to_string(scene.robots.size() - 1);
    scene.robots.back().execution->partner = "robot_5";
  }
  std::vector<bool> expected(scene.robots.size(), false);
  EXPECT_EQ(expected, inFront(scene)) << "all drive, and none is selected";
  EXPECT_NEAR(kBehindAlpha, findMarker(partnerMarkers(scene), "line", 0)->color.a, 1e-6);
  EXPECT_NEAR(kBehindAlpha, findMarker(pathMarkers(scene), "line", 0)->color.a, 1e-6);
  EXPECT_EQ(nullptr, findMarker(svoMarkers(scene), "value", 0));
  EXPECT_NE(nullptr, findMarker(svoMarkers(scene), "gauge", 0));
  scene.selected = "robot_0";
  expected[0] = expected[1] = true;
  EXPECT_EQ(expected, inFront(scene)) << "with its partner";
  EXPECT_EQ(1.0F, findMarker(partnerMarkers(scene), "line", 0)->color.a);
  EXPECT_NE(nullptr, findMarker(svoMarkers(scene), "value", 0));
  scene.robots[3].execution->waiting = 1;
  scene.robots[3].execution->waits_for_robot = "robot_4";
  scene.robots[3].execution->root_cause_robot = "robot_6";
  scene.robots[8].execution->condition = sylph_msgs::RobotExecution::BLIND;
  expected[3] = expected[4] = expected[6] = expected[8] = true;
  EXPECT_EQ(expected, inFront(scene));
}

TEST(LayersTest, AreEmptyForAnEmptySceneAndLeaveOutWhoHasNoPose) {
  for (const Layer& layer : kLayers) {
    EXPECT_TRUE(layer.draw(Scene{}).empty()) << layer.topic;
  }
  Scene scene = twoRobots();
  scene.robots[0].pose.reset();
  EXPECT_EQ(nullptr, findMarker(robotMarkers(scene), "body", 0));
  EXPECT_NE(nullptr, findMarker(robotMarkers(scene), "body", 1));
  EXPECT_TRUE(partnerMarkers(scene).empty());
}

TEST(RobotMarkersTest, DrawTheFootprintLockedToTheRobotAndFaintWhenStale) {
  Scene scene = twoRobots();
  scene.robots[1].length_m = 0.5;
  scene.robots[1].pose_is_stale = true;
  const Markers markers = robotMarkers(scene);
  const Marker* body = findMarker(markers, "body", 1);
  ASSERT_NE(nullptr, body);
  EXPECT_EQ("robot_1", body->header.frame_id);
  EXPECT_TRUE(body->frame_locked);
  EXPECT_DOUBLE_EQ(0.5, body->scale.x);
  EXPECT_DOUBLE_EQ(0.2, body->scale.y);
  EXPECT_LT(body->color.a, 0.9F);
  EXPECT_FLOAT_EQ(1.0F, findMarker(markers, "body", 0)->color.a);
  EXPECT_EQ("1", findMarker(markers, "name", 1)->text);
}

TEST(GoalMarkersTest, ShowTheExperimentsGoalUntilThereIsAPlan) {
  Scene scene = twoRobots();
  scene.robots[1].goal = sylph::Cell{0, 2};
  EXPECT_NEAR(1.35, findMarker(goalMarkers(scene), "name", 1)->pose.position.x, 1e-9);
  scene.state->plan_id = 0;
  EXPECT_NEAR(0.75, findMarker(goalMarkers(scene), "name", 1)->pose.position.x, 1e-9);
}

TEST(GoalMarkersTest, HaveNoneForARobotWithoutMissionAndPose) {
  Scene scene = twoRobots();
  scene.robots[1].pose.reset();
  scene.robots[1].execution = sylph_msgs::RobotExecution();
  const Markers markers = goalMarkers(scene);
  EXPECT_NE(nullptr, findMarker(markers, "ring", 0));
  EXPECT_EQ(nullptr, findMarker(markers, "ring", 1)) << "in the map's corner";
}

TEST(GoalMarkersTest, HaveAnotherFormThanRobots) {
  const Scene scene = twoRobots();
  EXPECT_NE(findMarker(robotMarkers(scene), "body", 0)->type,
            findMarker(goalMarkers(scene), "ring", 0)->type);
}

TEST(PathMarkersTest, LeadFromTheRobotThroughTheCellsToCome) {
  const Markers markers = pathMarkers(twoRobots());
  ASSERT_EQ(1U, markers.size());            // robot_1 has arrived
  ASSERT_EQ(6U, markers[0].points.size());  // three pieces
  EXPECT_NEAR(0.15, markers[0].points[0].x, 1e-9);
  EXPECT_NEAR(0.15, markers[0].points[0].y, 1e-9);
  EXPECT_EQ(markers[0].points[1], markers[0].points[2]);
  EXPECT_NEAR(1.05, markers[0].points[5].y, 0.1);
}

TEST(PartnerMarkersTest, PointFromTheRobotToItsPartnerInTheColorOfTheSvo) {
  const Markers markers = partnerMarkers(twoRobots());
  const Marker* line = findMarker(markers, "line", 0);
  ASSERT_NE(nullptr, line);
  EXPECT_EQ(nullptr, findMarker(markers, "line", 1));
  EXPECT_LT(std::abs(line->points.front().x - 0.15), std::abs(line->points.front().x - 1.35));
  EXPECT_LT(std::abs(line->points.back().x - 1.35), std::abs(line->points.back().x - 0.15));
  EXPECT_TRUE(line->color == svoColor(25.0));
}

TEST(SvoMarkersTest, WriteTheNumberOrADash) {
  const Markers markers = svoMarkers(twoRobots());
  EXPECT_EQ("25", findMarker(markers, "value", 0)->text);
  EXPECT_EQ("-", findMarker(markers, "value", 1)->text);
  EXPECT_EQ(nullptr, findMarker(markers, "gauge", kGaugeMarkers + 1)) << "filled without an SVO";
}

TEST(SvoGaugeTest, OpensByTheSvo) {
  for (const double svo_deg : {5.0, 20.0, 45.0}) {
    const Markers markers = svoGauge("gauge", 0, svo_deg, 0.2);
    const Marker* filled = findMarker(markers, "gauge", 1);
    ASSERT_NE(nullptr, filled);
    double widest_deg = 0.0;
    for (const geometry_msgs::Point& point : filled->points) {
      widest_deg = std::max(widest_deg, std::atan2(point.y, point.x) * 180.0 / M_PI);
    }
    EXPECT_NEAR(svo_deg, widest_deg, 1e-9);
  }
  EXPECT_EQ(nullptr, findMarker(svoGauge("gauge", 0, 0.0, 0.2), "gauge", 1));
}

TEST(StatusBadgeTest, HasAFormOfItsOwnForEachStatus) {
  const std::set<std::tuple<int, std::size_t>> forms = {
      signOf(RobotStatus::Enqueued), signOf(RobotStatus::Staged), signOf(RobotStatus::Done),
      signOf(RobotStatus::Held), signOf(RobotStatus::Unknown)};
  EXPECT_EQ(5U, forms.size());
  const Markers held = statusBadge("badge", 0, RobotStatus::Held, 0);
  const Markers fault = statusBadge("badge", 0, RobotStatus::Fault, 0);
  EXPECT_FALSE(held.back().points == fault.back().points);
}

TEST(StatusBadgeTest, PointsTheWayThatTheTaskDrives) {
  const auto tip = [](std::uint8_t action) {
    return statusBadge("badge", 0, RobotStatus::Enqueued, action).back().points.front();
  };
  EXPECT_GT(tip(1).y, 0.01);   // north
  EXPECT_GT(tip(2).x, 0.01);   // east
  EXPECT_LT(tip(3).y, -0.01);  // south
  EXPECT_LT(tip(4).x, -0.01);  // west
}

TEST(WaitMarkersTest, ShowWhoWaitsForWhomAndTheRootCause) {
  Scene scene = twoRobots();
  sylph_msgs::RobotExecution& robot = *scene.robots[0].execution;
  EXPECT_TRUE(waitMarkers(scene).empty());
  robot.waiting = 1;
  robot.waits_for_robot = "robot_1";
  robot.waited_s = 2.6;
  robot.root_cause_robot = "robot_1";
  robot.root_cause = "stuck";
  robot.waits_for_cell.row = 1;
  const Markers markers = waitMarkers(scene);
  ASSERT_NE(nullptr, findMarker(markers, "line", 0));
  ASSERT_NE(nullptr, findMarker(markers, "cell", 0));
  EXPECT_EQ("3 s", findMarker(markers, "time", 0)->text);
  EXPECT_EQ("robot_1", findMarker(markers, "root_cause", 1)->header.frame_id);
  EXPECT_EQ("holds up 1: stuck", findMarker(markers, "root_cause_text", 10)->text);

  robot.waited_s = 0.2;
  EXPECT_EQ(nullptr, findMarker(waitMarkers(scene), "root_cause_text", 10)) << "a short wait";
}

TEST(LegendMarkersTest, StandBesideTheMapAndCountTheArrived) {
  const Markers markers = legendMarkers(twoRobots());
  bool counted = false;
  for (const Marker& marker : markers) {
    EXPECT_GT(marker.pose.position.x, 1.5) << marker.ns << marker.id;
    counted = counted || marker.text == "1 of 2 arrived";
  }
  EXPECT_TRUE(counted);
}

/// robot_0 is selected, waits for robot_1, and that one for robot_2, which has a fault.
Scene chainOfThree() {
  Scene scene = twoRobots();
  RobotView third = scene.robots[1];
  third.name = "robot_2";
  third.pose = sylph::Pose2d{0.75, 0.75, 0.0};
  third.execution->robot_id = "robot_2";
  scene.robots.push_back(third);
  scene.robots[0].execution->waiting = 1;
  scene.robots[0].execution->waits_for_robot = "robot_1";
  scene.robots[1].execution->waiting = 1;
  scene.robots[1].execution->waits_for_robot = "robot_2";
  scene.selected = "robot_0";
  return scene;
}

TEST(SelectionMarkersTest, AreEmptyUnlessARobotThatThereIsIsSelected) {
  Scene scene = twoRobots();
  EXPECT_TRUE(selectionMarkers(scene).empty());
  scene.selected = "robot_9";
  EXPECT_TRUE(selectionMarkers(scene).empty());
}

TEST(SelectionMarkersTest, NumberTheChainOfWaitsToItsEnd) {
  const Markers markers = selectionMarkers(chainOfThree());
  ASSERT_NE(nullptr, findMarker(markers, "chain_number", 2));
  EXPECT_EQ("2", findMarker(markers, "chain_number", 2)->text);
  EXPECT_EQ(nullptr, findMarker(markers, "chain_number", 3));
}

TEST(SelectionMarkersTest, ShowHeldCellsPlannedAndDrivenPathAndThePartnersWay) {
  Scene scene = chainOfThree();
  scene.robots[0].execution->held_cells.resize(2);
  scene.robots[1].execution->remaining_path.resize(2);
  scene.robots[1].execution->remaining_path[1].col = 1;
  setPose(scene.robots[0], {0.15, 0.15, 0.0});
  setPose(scene.robots[0], {0.15, 0.25, 0.0});
  const Markers markers = selectionMarkers(scene);
  EXPECT_NE(nullptr, findMarker(markers, "held", 1));
  EXPECT_NE(nullptr, findMarker(markers, "partner", 0));
  EXPECT_NE(nullptr, findMarker(markers, "partner_way", 0));
  ASSERT_NE(nullptr, findMarker(markers, "planned", 0));
  EXPECT_EQ(6U, findMarker(markers, "planned", 0)->points.size()) << "three moves";
  ASSERT_NE(nullptr, findMarker(markers, "driven", 0));
  EXPECT_NEAR(0.25, findMarker(markers, "driven", 0)->points[1].y, 1e-9);
}

TEST(ShownPlanMarkersTest, ShowTheWaysOfAPlanUntilAMissionIsUnderWay) {
  Scene scene = twoRobots();
  scene.state->phase = sylph_msgs::AdgState::FINISHED;
  EXPECT_TRUE(shownPlanMarkers(scene).empty());
  scene.shown_plan = planOfOneMove();
  const Markers markers = shownPlanMarkers(scene);
  EXPECT_NE(nullptr, findMarker(markers, "line", 1));
  ASSERT_NE(nullptr, findMarker(markers, "ring", 1));
  EXPECT_EQ(nullptr, findMarker(markers, "line", 0)) << "it has no part in the plan";
  scene.state->phase = sylph_msgs::AdgState::EXECUTING;
  EXPECT_TRUE(shownPlanMarkers(scene).empty());
}

}  // namespace
}  // namespace sylph_rviz
