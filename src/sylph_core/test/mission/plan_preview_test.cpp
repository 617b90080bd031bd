#include "sylph_core/mission/plan_preview.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "small_lab.hpp"

namespace sylph {
namespace {

using Stage = PlanPreview::Stage;

/// The small lab; the clock stands still unless a test moves it.
class PlanPreviewTest : public testing::Test {
 protected:
  void ask() { preview_.ask(smallMission(), now_s_); }
  std::optional<PlanPreview::PlanningTask> tick(bool is_mission_under_way = false) {
    return preview_.tick(poses_, is_mission_under_way, now_s_);
  }
  /// Asks, and the plan is made at once.
  void plan() {
    ask();
    auto task = tick();
    ASSERT_TRUE(task);
    preview_.onPlanned(task->make());
  }
  /// Why there is no plan, in place of the answer; "a plan" if there is one, "none" if neither.
  std::string answer() {
    const auto outcome = preview_.takeAnswer();
    if (!outcome) {
      return "none";
    }
    const auto* failure = std::get_if<MissionFailure>(&*outcome);
    return failure != nullptr ? failure->what() : "a plan";
  }

  MissionLimits limits_;
  PlanPreview preview_{smallLab().robots, limits_};
  RobotPoses poses_ = posesInStarts();
  double now_s_ = 100.0;
};

TEST_F(PlanPreviewTest, RestsUntilItIsAsked) {
  EXPECT_FALSE(tick());
  EXPECT_EQ(Stage::Idle, preview_.stage());
  EXPECT_EQ("none", answer());
  EXPECT_EQ(0U, preview_.number());
}

TEST_F(PlanPreviewTest, KeepsThePlanThatItHasShown) {
  plan();
  EXPECT_EQ(Stage::Idle, preview_.stage());
  EXPECT_EQ("a plan", answer());
  EXPECT_EQ("none", answer()) << "it is told once";
  EXPECT_EQ(1U, preview_.number());
  EXPECT_EQ(smallStarts(), preview_.planOf(1, smallMission()).plan.front());
  plan();
  EXPECT_EQ(2U, preview_.number());
  EXPECT_EQ("1: plan 1 is not shown any more: plan again",
            failureOf([&] { preview_.planOf(1, smallMission()); }));
}

TEST_F(PlanPreviewTest, APlanIsOfItsMissionAlone) {
  plan();
  Mission other = smallMission();
  std::swap(other.goals[0], other.goals[1]);
  EXPECT_EQ("1: plan 1 is of other robots, goals or map: plan again",
            failureOf([&] { preview_.planOf(1, other); }));
  preview_.withdraw();
  EXPECT_EQ("1: plan 1 is not shown any more: plan again",
            failureOf([&] { preview_.planOf(1, smallMission()); }));
}

TEST_F(PlanPreviewTest, WhatIsShownIsGoneWhenAnotherPlanIsAskedFor) {
  plan();
  ask();
  EXPECT_EQ("1: plan 1 is not shown any more: plan again",
            failureOf([&] { preview_.planOf(1, smallMission()); }));
}

TEST_F(PlanPreviewTest, WaitsForPosesOnlySoLong) {
  const auto pose = poses_.at("robot_1");
  poses_.erase("robot_1");
  ask();
  EXPECT_FALSE(tick());
  EXPECT_EQ(Stage::Starting, preview_.stage());
  EXPECT_NE(std::string::npos, preview_.waitsFor().find("robot_1")) << preview_.waitsFor();
  poses_["robot_1"] = pose;
  EXPECT_TRUE(tick());
  EXPECT_EQ("", preview_.waitsFor());

  preview_ = PlanPreview(smallLab().robots, limits_);
  poses_.erase("robot_1");
  ask();
  now_s_ += limits_.pose_wait_s - 0.1;
  EXPECT_FALSE(tick());
  EXPECT_EQ("none", answer());
  now_s_ += 0.2;
  EXPECT_FALSE(tick());
  EXPECT_NE(std::string::npos, answer().find("robot_1"));
  EXPECT_EQ(Stage::Idle, preview_.stage());
}

TEST_F(PlanPreviewTest, PlansNothingWhileAMissionIsUnderWay) {
  ask();
  EXPECT_FALSE(tick(true));
  EXPECT_EQ("a mission is under way: plan when it has ended, or cancel it", answer());
  EXPECT_EQ(Stage::Idle, preview_.stage());
}

TEST_F(PlanPreviewTest, APlanForWhoHasCancelledIsDropped) {
  ask();
  auto task = tick();
  ASSERT_TRUE(task);
  preview_.cancel();
  preview_.onPlanned(task->make());
  EXPECT_EQ("none", answer());
  EXPECT_EQ(0U, preview_.number());
}

TEST_F(PlanPreviewTest, TheNextClientWaitsForTheEndOfThePlanBeforeAndGetsItsOwn) {
  ask();
  auto before = tick();
  ASSERT_TRUE(before);
  ask();
  EXPECT_FALSE(tick()) << "two plans at once";
  EXPECT_EQ(Stage::Starting, preview_.stage());
  preview_.onPlanned(before->make());
  EXPECT_EQ("none", answer());
  auto own = tick();
  ASSERT_TRUE(own);
  preview_.onPlanned(own->make());
  EXPECT_EQ("a plan", answer());
}

}  // namespace
}  // namespace sylph
