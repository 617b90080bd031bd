#include "sylph_core/search/large_neighborhood_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/planners/first_solution.hpp"
#include "sylph_core/planners/improvement.hpp"
#include "sylph_core/search/distance_generator.hpp"

namespace sylph {
namespace {

Instance crowd(std::uint32_t seed, bool rotations) {
  Rng rng(seed);
  Grid grid(10, 10);
  for (const Cell& cell : drawCells(grid, 8, rng)) {
    grid.setObstacle(cell);
  }
  return randomInstance(grid, 35, {rotations}, rng);
}

TEST(LargeNeighborhoodSearchTest, LowersTheCostOfLegalPlans) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Instance instance = crowd(seed, seed % 2 == 0);
    const SearchProblem problem(instance);
    Rng rng(seed);
    const FirstSolution first =
        findFirstSolution(problem, makeDistanceGenerator, Deadline(10.0), rng);
    ASSERT_EQ(Lacam::Status::Solved, first.status);
    problem.distances.completeAll(Deadline(60.0));
    LargeNeighborhoodSearch search(problem, first.plan);
    const long cost_before = search.cost();
    search.run(Deadline(0.1), 0.5, rng);
    const Plan plan = problem.graph.toPlan(search.plan());
    const auto violation = checkPlan(instance, plan);
    ASSERT_FALSE(violation.has_value()) << violation->message;
    EXPECT_LT(search.cost(), cost_before);
    EXPECT_GT(search.improvementCount(), 0);
    EXPECT_EQ(search.cost(), computeMetrics(instance, plan).sum_of_costs);
  }
}

TEST(LargeNeighborhoodSearchTest, TakesOnlyBetterOffers) {
  const Instance instance{Grid(1, 3), {{0, 0}}, {{0, 2}}, {}};
  const SearchProblem problem(instance);
  const std::vector<Vertices> slow = {{0}, {0}, {1}, {2}};
  const std::vector<Vertices> fast = {{0}, {1}, {2}};
  LargeNeighborhoodSearch search(problem, slow);
  EXPECT_EQ(3, search.cost());
  search.offer(fast);
  EXPECT_EQ(fast, search.plan());
  search.offer(slow);
  EXPECT_EQ(fast, search.plan());
}

TEST(NeighborhoodsTest, EveryKindPicksDifferentAgentsUpToTheSize) {
  const Instance instance = crowd(1, false);
  const SearchProblem problem(instance);
  Rng rng(1);
  const FirstSolution first =
      findFirstSolution(problem, makeDistanceGenerator, Deadline(10.0), rng);
  ReservationTable table(problem.graph, instance.motion, instance.agentCount(),
                         static_cast<int>(first.plan.size()));
  const std::vector<VertexPath> paths = pathsOf(first.plan);
  for (AgentId agent = 0; agent < instance.agentCount(); ++agent) {
    table.insert(agent, paths[agent]);
  }
  Neighborhoods neighborhoods(problem, table, ImprovementSettings());
  for (const NeighborhoodKind kind : kNeighborhoodKinds) {
    for (int size = 1; size <= instance.agentCount(); ++size) {
      const std::vector<AgentId> agents = neighborhoods.pick(kind, size, rng);
      EXPECT_GE(agents.size(), 1U);
      EXPECT_LE(agents.size(), static_cast<std::size_t>(size));
      EXPECT_EQ(agents.size(), std::set<AgentId>(agents.begin(), agents.end()).size());
    }
  }
}

TEST(ImproveTest, ProvesTheOptimumOfASmallInstance) {
  // The two have to pass each other in a corridor with one bay: one steps into it and back.
  const Instance instance{Grid::fromText("....\n#.##\n"), {{0, 0}, {0, 3}}, {{0, 3}, {0, 0}}, {}};
  const SearchProblem problem(instance);
  Rng rng(1);
  const Deadline deadline(60.0);
  const FirstSolution first = findFirstSolution(problem, makeDistanceGenerator, deadline, rng);
  const Improvement improvement =
      improve(problem, first.plan, makeDistanceGenerator, 1, deadline, rng);
  EXPECT_LT(deadline.elapsed(), 30.0);
  EXPECT_EQ(8, computeMetrics(instance, problem.graph.toPlan(improvement.plan)).sum_of_costs);
}

TEST(ImproveTest, EndsAtACostThatIsProved) {
  const Instance instance = crowd(2, false);
  const SearchProblem problem(instance);
  Rng rng(1);
  const FirstSolution first =
      findFirstSolution(problem, makeDistanceGenerator, Deadline(10.0), rng);
  const long cost = sumOfCosts(pathsOf(first.plan));
  const Deadline deadline(60.0);
  EXPECT_EQ(first.plan,
            improve(problem, first.plan, makeDistanceGenerator, 1, deadline, rng, cost).plan);
  const Improvement improvement =
      improve(problem, first.plan, makeDistanceGenerator, 1, deadline, rng, cost - 5);
  EXPECT_GE(cost - 5, sumOfCosts(pathsOf(improvement.plan)));
  EXPECT_FALSE(deadline.isOver());
}

TEST(ImproveTest, SeveralThreadsReturnALegalPlan) {
  const Instance instance = crowd(2, false);
  const SearchProblem problem(instance);
  Rng rng(1);
  const FirstSolution first =
      findFirstSolution(problem, makeDistanceGenerator, Deadline(10.0), rng);
  const Improvement improvement =
      improve(problem, first.plan, makeDistanceGenerator, 3, Deadline(0.3), rng);
  const auto violation = checkPlan(instance, problem.graph.toPlan(improvement.plan));
  ASSERT_FALSE(violation.has_value()) << violation->message;
  EXPECT_LT(sumOfCosts(pathsOf(improvement.plan)), sumOfCosts(pathsOf(first.plan)));
}

}  // namespace
}  // namespace sylph
