#include "sylph_core/mission/checked_plan.hpp"

#include <gtest/gtest.h>

#include "small_lab.hpp"
#include "sylph_core/mapf/check_plan.hpp"

namespace sylph {
namespace {

TEST(ToInstanceTest, RulesOutRotations) {
  const Instance instance = toInstance(smallMission(), smallStarts(), {});
  EXPECT_FALSE(instance.motion.rotations);
  EXPECT_EQ(smallStarts(), instance.starts);
  EXPECT_EQ(smallMission().goals, instance.goals);
}

TEST(ToInstanceTest, NamesTheRobotThatIsCutOff) {
  const CellOwners wall = {{{0, 2}, "robot_8"}, {{2, 2}, "robot_9"}};
  EXPECT_EQ(
      "1: goal (0,4) of robot_0 cannot be reached from its cell (0,0) past robots without part in "
      "the mission: robot_8, robot_9",
      failureOf([&] { toInstance(smallMission(), smallStarts(), wall); }));
}

TEST(ToInstanceTest, NamesTheRobotThatTouchesABystander) {
  EXPECT_EQ("2: robot_1 in cell (2,4) is too near to robot_9, which has no part in the mission",
            failureOf([&] {
              toInstance(smallMission(), smallStarts(), {{{2, 4}, "robot_9"}});
            }));
}

TEST(PlanMissionTest, ReachesAllGoalsAndKnowsTheSocialStateOfEachStep) {
  const Instance instance = toInstance(smallMission(), smallStarts(), {});
  const CheckedPlan plan = planMission(smallMission(), instance);
  EXPECT_FALSE(checkPlan(instance, plan.plan));
  EXPECT_EQ(3, plan.metrics.arrived);
  EXPECT_EQ(plan.plan.size() - 1, plan.social.size());
  for (const SocialState& state : plan.social) {
    EXPECT_EQ(3U, state.partners.size());
    EXPECT_EQ(3U, state.svo_deg.size());
  }
}

TEST(PlanMissionTest, LimitedBySearchStepsTheSamePlanIsMadeEachTime) {
  Mission mission = smallMission();
  mission.time_limit_s = 2.0;
  mission.search_steps_per_s = 500.0;
  const Instance instance = toInstance(mission, smallStarts(), {});
  const CheckedPlan once = planMission(mission, instance);
  const CheckedPlan again = planMission(mission, instance);
  EXPECT_EQ(once.plan, again.plan);
  EXPECT_EQ(once.planning_s, again.planning_s);
  EXPECT_GT(once.planning_s, 0.0);
  EXPECT_LT(once.planning_s, 1.1 * mission.time_limit_s);
}

TEST(PlanMissionTest, TellsWhenThereIsNoPlan) {
  Mission mission = smallMission();
  mission.grid = Grid::fromText("...\n");
  mission.robots = {"robot_0", "robot_1"};
  mission.goals = {{0, 2}, {0, 0}};
  const Instance instance = toInstance(mission, {{0, 0}, {0, 2}}, {});
  const std::string failure = failureOf([&] { planMission(mission, instance); });
  EXPECT_EQ("3: planner lacam found no plan", failure.substr(0, 30)) << failure;
}

TEST(CertificateOfTest, TellsCostAndWhatWasChecked) {
  Mission mission = smallMission();
  mission.robots = {"robot_0"};
  mission.goals = {{0, 4}};
  const CheckedPlan plan = planMission(mission, toInstance(mission, {{0, 0}}, {}));
  EXPECT_EQ(
      "4 steps, sum of costs 4, the least there is; checked: no two robots in one cell, none swap "
      "or rotate, it ends on its goal",
      certificateOf(plan));
  CheckedPlan longer = plan;
  longer.metrics.sum_of_costs = 5;
  longer.least_sum_of_costs = 3;
  EXPECT_EQ("4 steps, sum of costs 5, at most 67 % above the least;",
            certificateOf(longer).substr(0, 54));
  longer.least_sum_of_costs.reset();
  EXPECT_EQ("4 steps, sum of costs 5;", certificateOf(longer).substr(0, 24));
}

TEST(StillFittingTest, TakesAPlanForRobotsThatHaveNotMoved) {
  const Instance instance = toInstance(smallMission(), smallStarts(), {});
  const CheckedPlan plan = planMission(smallMission(), instance);
  EXPECT_EQ(plan.plan, stillFitting(smallMission(), instance, plan).plan);
}

TEST(StillFittingTest, NamesTheRobotThatHasMoved) {
  const CheckedPlan plan =
      planMission(smallMission(), toInstance(smallMission(), smallStarts(), {}));
  Configuration moved = smallStarts();
  moved[1] = {2, 3};
  EXPECT_EQ("1: robot_1 stands in (2,3), where the plan that was shown begins in (2,4): plan again",
            failureOf([&] {
              stillFitting(smallMission(), toInstance(smallMission(), moved, {}), plan);
            }));
}

TEST(StillFittingTest, RefusesAPlanThroughARobotThatHasComeInItsWay) {
  Mission mission = smallMission();
  mission.robots = {"robot_0"};
  mission.goals = {{0, 4}};
  const CheckedPlan plan = planMission(mission, toInstance(mission, {{0, 0}}, {}));
  ASSERT_EQ(5U, plan.plan.size());
  const Instance now = toInstance(mission, {{0, 0}}, {{{0, 2}, "robot_1"}});
  const std::string failure = failureOf([&] { stillFitting(mission, now, plan); });
  EXPECT_EQ(0U, failure.find("1: the plan that was shown does not fit any more, ")) << failure;
}

TEST(PlanAsFarAsPossibleTest, EndsWhereThePlannerCame) {
  Mission mission = smallMission();
  mission.grid = Grid::fromText("...\n");
  const Instance instance = {mission.grid, {{0, 0}, {0, 2}}, {{0, 2}, {0, 0}}, {}};
  const CheckedPlan plan = planAsFarAsPossible(mission, instance);
  ASSERT_FALSE(plan.plan.empty());
  EXPECT_EQ(instance.starts, plan.plan.front());
  EXPECT_EQ(plan.instance.goals, plan.plan.back());
  EXPECT_FALSE(checkPlan(plan.instance, plan.plan));
}

}  // namespace
}  // namespace sylph
