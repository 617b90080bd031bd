#include "sylph_core/search/group_delay.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "joint_search.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/random_instance.hpp"

namespace sylph {
namespace {

constexpr int kWhatever = 1'000'000;

Deadline enough() {
  return Deadline(60.0);
}

void expectExactGroups(bool rotations) {
  int delayed_count = 0;
  for (std::uint32_t seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = crowdedInstance(4, rotations, rng);
    const auto least = leastSumOfCostsByJointSearch(instance);
    if (instance.agentCount() < 3 || !least) {
      continue;
    }
    const SearchProblem problem(instance);
    const auto costs = PairCosts::compute(problem, enough());
    ASSERT_TRUE(costs.has_value());
    std::vector<AgentId> agents(instance.starts.size());
    std::iota(agents.begin(), agents.end(), 0);
    GroupDelay group(problem, *costs, agents, 0);
    ASSERT_TRUE(group.prove(kWhatever, enough()));
    ASSERT_EQ(*least, problem.distances.sum(problem.starts) + group.delay())
        << instance.grid.toText();
    delayed_count += group.delay() > 0 ? 1 : 0;
  }
  EXPECT_GT(delayed_count, 50);
}

TEST(GroupDelayTest, IsThatOfTheJointSearchWithoutRotations) {
  expectExactGroups(false);
}

TEST(GroupDelayTest, IsThatOfTheJointSearchWithRotations) {
  expectExactGroups(true);
}

TEST(GroupDelayTest, KeepsWhatItHasProvedWhenTheTimeIsOver) {
  int cut_count = 0;
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = randomInstance(Grid(3, 3), 4, {}, rng);
    const SearchProblem problem(instance);
    const auto costs = PairCosts::compute(problem, enough());
    ASSERT_TRUE(costs.has_value());
    GroupDelay exact(problem, *costs, {0, 1, 2, 3}, 0);
    ASSERT_TRUE(exact.prove(kWhatever, enough()));
    GroupDelay cut(problem, *costs, {0, 1, 2, 3}, 0);
    if (!cut.prove(kWhatever, Deadline(0.0))) {
      ++cut_count;
      EXPECT_LE(cut.delay(), exact.delay());
    }
  }
  EXPECT_GT(cut_count, 0);
}

}  // namespace
}  // namespace sylph
