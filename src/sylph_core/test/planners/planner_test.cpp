#include "sylph_core/planners/planner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sylph_core/grid/components.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "test/support/random_weights.hpp"

namespace sylph {
namespace {

Instance randomInstance(std::uint32_t seed, int side, double density, int agents, bool rotations) {
  Rng rng(seed);
  Instance instance{Grid(side, side), {}, {}, {rotations}};
  for (int index = 0; index < instance.grid.size(); ++index) {
    instance.grid.setObstacle(instance.grid.cellAt(index),
                              static_cast<double>(rng()) < density * 4294967296.0);
  }
  Configuration cells = connectedComponents(instance.grid).cells.front();
  shuffle(cells, rng);
  instance.starts.assign(cells.begin(), cells.begin() + agents);
  shuffle(cells, rng);
  instance.goals.assign(cells.begin(), cells.begin() + agents);
  return instance;
}

TEST(MakePlannerTest, SomePlannersNeedAPolicy) {
  for (const std::string& name : plannerNames()) {
    if (needsPolicy(name)) {
      EXPECT_THROW(makePlanner(name), std::invalid_argument);
    } else {
      EXPECT_EQ(name, makePlanner(name)->name());
    }
  }
  EXPECT_TRUE(needsPolicy("sylph"));
  EXPECT_FALSE(needsPolicy("lacam"));
}

TEST(MakePlannerTest, KnowsItsNames) {
  for (const std::string& name : plannerNames()) {
    EXPECT_EQ(name, makePlanner(name, randomPolicy())->name());
  }
}

TEST(MakePlannerTest, NamesTheAllowedOnesWhenAskedForAnother) {
  try {
    makePlanner("astar");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("lacam"));
    EXPECT_NE(std::string::npos, std::string(error.what()).find("astar"));
  }
}

TEST(PlannerTest, EveryKindReturnsLegalPlansUnderEitherMotionModel) {
  PlanningLimits limits;
  limits.time_limit_s = 0.2;
  for (const std::string& name : plannerNames()) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const Instance instance = randomInstance(seed, 12, 0.15, 30, seed % 2 == 0);
      Rng rng(seed);
      const PlanningResult result = makePlanner(name, randomPolicy())->plan(instance, limits, rng);
      const auto violation = checkPlan(instance, result.plan);
      if (result.outcome == Outcome::Solved) {
        ASSERT_FALSE(violation.has_value()) << violation->message;
      } else {
        ASSERT_TRUE(violation && violation->kind == ViolationKind::GoalNotReached);
      }
      EXPECT_LE(result.social.size(), result.plan.size() - 1);  // all, if there is time
    }
  }
}

TEST(PlannerTest, PibtIsNeverStoppedByARingThatItMayNotClose) {
  PlanningLimits limits;
  limits.max_steps = 60;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Instance instance = randomInstance(seed, 5, 0.0, 22, false);
    Rng rng(seed);
    const PlanningResult result = makePlanner("pibt")->plan(instance, limits, rng);
    const auto violation = checkPlan(instance, result.plan);
    EXPECT_TRUE(!violation || violation->kind == ViolationKind::GoalNotReached)
        << violation->message;
  }
}

TEST(PlannerTest, TheSameSeedGivesTheSameFirstPlan) {
  const Instance instance = randomInstance(5, 16, 0.2, 60, false);
  PlanningLimits limits;
  limits.first_solution_only = true;
  limits.time_limit_s = 60.0;
  limits.max_steps = 100;
  for (const std::string& name : plannerNames()) {
    Rng one(7);
    Rng other(7);
    EXPECT_EQ(makePlanner(name, randomPolicy())->plan(instance, limits, one).plan,
              makePlanner(name, randomPolicy())->plan(instance, limits, other).plan);
  }
}

TEST(PlannerTest, AnInstanceThatIsSolvedAlreadyNeedsNoStep) {
  const Instance instance{Grid(2, 2), {{0, 0}}, {{0, 0}}, {}};
  for (const std::string& name : plannerNames()) {
    Rng rng(1);
    const PlanningResult result = makePlanner(name, randomPolicy())->plan(instance, {}, rng);
    EXPECT_EQ(Outcome::Solved, result.outcome);
    EXPECT_EQ(Plan{instance.starts}, result.plan);
    EXPECT_TRUE(result.social.empty());
  }
}

TEST(PlannerTest, EndsWhenNoPlanCanBeBetter) {
  // One agent has to wait in the bay, the other to come out of a corridor's end: the sum of
  // distances does not tell.
  const Instance instance{Grid::fromText("....\n#.##\n"), {{0, 0}, {0, 3}}, {{0, 3}, {0, 0}}, {}};
  PlanningLimits limits;
  limits.time_limit_s = 600.0;
  Rng rng(1);
  const PlanningResult result = makePlanner("lacam")->plan(instance, limits, rng);
  EXPECT_LT(result.statistics.total_s, limits.time_limit_s);
  EXPECT_EQ(6, result.statistics.sum_of_costs_lower_bound);
  EXPECT_EQ(8, result.statistics.proved_sum_of_costs);
  EXPECT_EQ(8, computeMetrics(instance, result.plan).sum_of_costs);
}

TEST(PlannerTest, SaysWhenThePlanWouldBeTooLong) {
  const Instance instance{Grid(1, 9), {{0, 0}}, {{0, 8}}, {}};
  PlanningLimits limits;
  limits.max_steps = 7;
  for (const std::string& name : plannerNames()) {
    Rng rng(1);
    const auto planner = makePlanner(name, randomPolicy());
    const PlanningResult result = planner->plan(instance, limits, rng);
    EXPECT_EQ(Outcome::StepLimit, result.outcome);
    EXPECT_EQ(8U, result.plan.size()) << "as far as max_steps";
    EXPECT_EQ(7U, result.social.size());
  }
}

TEST(PlannerTest, SocialStatesAreOnlyMadeWhereTheyAreWanted) {
  const Instance instance{Grid(1, 9), {{0, 0}}, {{0, 8}}, {}};
  PlanningLimits limits;
  limits.time_limit_s = 1.0;
  for (const std::string& name : plannerNames()) {
    SCOPED_TRACE(name);
    for (const bool social_states : {false, true}) {
      limits.social_states = social_states;
      Rng rng(1);
      const PlanningResult result = makePlanner(name, randomPolicy())->plan(instance, limits, rng);
      EXPECT_EQ(social_states ? result.plan.size() - 1 : 0U, result.social.size());
    }
  }
}

}  // namespace
}  // namespace sylph
