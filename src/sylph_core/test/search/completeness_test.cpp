#include <gtest/gtest.h>

#include <algorithm>

#include "joint_search.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {
namespace {

constexpr double kEnough_s = 60.0;
constexpr long kNoStepLimit = -1;

void expectSolvedExactlyIfSolvable(bool rotations) {
  const auto planner = makePlanner("lacam");
  PlanningLimits limits;
  limits.first_solution_only = true;
  limits.time_limit_s = kEnough_s;
  int solvable_count = 0;
  constexpr int kInstances = 2000;
  for (std::uint32_t seed = 0; seed < kInstances; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = crowdedInstance(4, rotations, rng);
    const bool is_solvable = leastCostByJointSearch(instance).has_value();
    const PlanningResult result = planner->plan(instance, limits, rng);
    ASSERT_EQ(is_solvable ? Outcome::Solved : Outcome::Unsolvable, result.outcome)
        << instance.grid.toText();
    if (is_solvable) {
      ++solvable_count;
      const auto violation = checkPlan(instance, result.plan);
      ASSERT_FALSE(violation.has_value()) << violation->message;
    }
  }
  EXPECT_GT(solvable_count, kInstances / 4);
  EXPECT_LT(solvable_count, kInstances * 3 / 4);
}

TEST(LacamCompletenessTest, SolvesExactlyTheSolvableWithoutRotations) {
  expectSolvedExactlyIfSolvable(false);
}

TEST(LacamCompletenessTest, SolvesExactlyTheSolvableWithRotations) {
  expectSolvedExactlyIfSolvable(true);
}

TEST(LacamCompletenessTest, ARingThatIsFullNeedsRotations) {
  Instance instance{Grid(2, 2),
                    {{0, 0}, {0, 1}, {1, 1}, {1, 0}},
                    {{0, 1}, {1, 1}, {1, 0}, {0, 0}},
                    MotionModel{false}};
  Rng rng(1);
  EXPECT_EQ(Outcome::Unsolvable, makePlanner("lacam")->plan(instance, {}, rng).outcome);
  instance.motion.rotations = true;
  const PlanningResult result = makePlanner("lacam")->plan(instance, {}, rng);
  EXPECT_EQ(Outcome::Solved, result.outcome);
  EXPECT_EQ(2U, result.plan.size());
}

TEST(LacamTest, ExhaustedItsCostIsTheLeast) {
  int improved_count = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = crowdedInstance(3, seed % 2 == 0, rng);
    const SearchProblem problem(instance);
    const auto generator = makeDistanceGenerator(problem, 0, rng);
    Lacam lacam(problem, *generator, rng);
    auto status = lacam.search(Deadline(kEnough_s), kNoStepLimit);
    for (; status == Lacam::Status::Solved;
         status = lacam.search(Deadline(kEnough_s), kNoStepLimit)) {
      const auto violation = checkPlan(instance, problem.graph.toPlan(lacam.plan()));
      ASSERT_FALSE(violation.has_value()) << violation->message;
      ++improved_count;
    }
    ASSERT_EQ(Lacam::Status::Exhausted, status);
    const auto least_cost = leastCostByJointSearch(instance);
    ASSERT_EQ(least_cost.has_value(), lacam.isSolved());
    if (least_cost) {
      ASSERT_EQ(*least_cost, lacam.cost());
    }
  }
  EXPECT_GT(improved_count, 100);
}

TEST(LacamTest, TakesInASolutionFromElsewhere) {
  Instance instance{Grid(3, 3), {{0, 0}, {2, 2}}, {{2, 2}, {0, 0}}, {}};
  const SearchProblem problem(instance);
  Rng rng(3);
  PlanningLimits limits;
  limits.time_limit_s = kEnough_s;
  const PlanningResult result = makePlanner("lacam")->plan(instance, limits, rng);
  std::vector<Vertices> plan;
  for (const Configuration& cells : result.plan) {
    plan.push_back(problem.graph.toVertices(cells));
  }
  const auto generator = makeDistanceGenerator(problem, 0, rng);
  Lacam lacam(problem, *generator, rng);
  lacam.insert(plan, Deadline(kEnough_s));
  EXPECT_TRUE(lacam.isSolved());
  EXPECT_EQ(plan, lacam.plan());
  EXPECT_EQ(8, lacam.cost());
}

}  // namespace
}  // namespace sylph
