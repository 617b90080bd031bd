#include "sylph_core/search/pair_costs.hpp"

#include <gtest/gtest.h>

#include "joint_search.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/random_instance.hpp"

namespace sylph {
namespace {

Deadline enough() {
  return Deadline(60.0);
}

TEST(PairCostsTest, AreThoseOfTheJointSearch) {
  int delayed_count = 0;
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = crowdedInstance(2, false, rng);
    if (instance.agentCount() < 2) {
      continue;
    }
    const SearchProblem problem(instance);
    const auto costs = PairCosts::compute(problem, enough());
    ASSERT_TRUE(costs.has_value());
    const int delay = costs->delay(0, {problem.starts[0], false}, 1, {problem.starts[1], false});
    EXPECT_EQ(delay, costs->delay(1, {problem.starts[1], false}, 0, {problem.starts[0], false}));
    const auto least = leastSumOfCostsByJointSearch(instance);
    ASSERT_EQ(least.value_or(PairCosts::kNoWay),
              delay == PairCosts::kNoWay ? delay : problem.distances.sum(problem.starts) + delay)
        << instance.grid.toText();
    delayed_count += delay > 0 ? 1 : 0;
  }
  EXPECT_GT(delayed_count, 200);
}

TEST(PairCostsTest, WhoHasArrivedIsAnObstacle) {
  const Instance instance{Grid(3, 3), {{0, 0}, {0, 1}}, {{0, 2}, {0, 1}}, {}};
  const SearchProblem problem(instance);
  const auto costs = PairCosts::compute(problem, enough());
  ASSERT_TRUE(costs.has_value());
  EXPECT_EQ(2, costs->delay(0, {problem.starts[0], false}, 1, {problem.starts[1], true}));
  EXPECT_EQ(0, costs->delay(0, {problem.goals[0], true}, 1, {problem.starts[1], true}));
}

TEST(PairCostsTest, LeavesLargeMapsAlone) {
  Rng rng(1);
  const Instance instance = randomInstance(Grid(64, 64), 2, {}, rng);
  EXPECT_FALSE(PairCosts::compute(SearchProblem(instance), enough()).has_value());
}

}  // namespace
}  // namespace sylph
