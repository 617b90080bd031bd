#include "sylph_core/search/cost_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "joint_search.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/random_instance.hpp"

namespace sylph {
namespace {

constexpr long kWhatever = 1'000'000;

Deadline enough() {
  return Deadline(60.0);
}

/// By trying all delays.
bool canBeLate(const std::vector<DelayOfAgents>& groups, std::vector<int>& delays,
               std::size_t agent, int sum) {
  if (agent == delays.size()) {
    for (const DelayOfAgents& group : groups) {
      int delay = 0;
      for (std::size_t member = 0; member < delays.size(); ++member) {
        delay += (group.agents >> member & 1U) != 0 ? delays[member] : 0;
      }
      if (delay < group.delay) {
        return false;
      }
    }
    return true;
  }
  for (int delay = 0; delay <= sum; ++delay) {
    delays[agent] = delay;
    if (canBeLate(groups, delays, agent + 1, sum - delay)) {
      return true;
    }
  }
  return false;
}

TEST(LeastTeamDelayTest, IsTheLeastByTryingAll) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int agents = 2 + static_cast<int>(drawIndex(rng, 4));
    std::vector<DelayOfAgents> groups;
    for (std::uint32_t members = 3; members < 1U << agents; ++members) {
      if (drawIndex(rng, 3) == 0 && (members & (members - 1U)) != 0) {
        groups.push_back({members, static_cast<int>(drawIndex(rng, 6))});
      }
    }
    const int least = leastTeamDelay(groups, agents);
    std::vector<int> delays(static_cast<std::size_t>(agents));
    EXPECT_TRUE(canBeLate(groups, delays, 0, least));
    EXPECT_FALSE(least > 0 && canBeLate(groups, delays, 0, least - 1));
  }
}

TEST(ProvedSumOfCostsTest, NoPlanCostsLess) {
  int exact_count = 0;
  int better_count = 0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = crowdedInstance(4, seed % 2 == 0, rng);
    const auto least = leastSumOfCostsByJointSearch(instance);
    if (!least) {
      continue;
    }
    const SearchProblem problem(instance);
    const long proved = provedSumOfCosts(problem, kWhatever, enough());
    ASSERT_LE(proved, *least) << instance.grid.toText();
    exact_count += proved == *least ? 1 : 0;
    better_count += proved > problem.distances.sum(problem.starts) ? 1 : 0;
    const long asked = problem.distances.sum(problem.starts) + 1;
    EXPECT_EQ(std::min(proved, asked), provedSumOfCosts(problem, asked, enough()));
  }
  EXPECT_GT(exact_count, 100);
  EXPECT_GT(better_count, 50);
}

TEST(ProvedSumOfCostsTest, IsTheSumOfDistancesOfLargeTeams) {
  Rng rng(4);
  const Instance instance = randomInstance(Grid(12, 12), 40, {}, rng);
  const SearchProblem problem(instance);
  EXPECT_EQ(problem.distances.sum(problem.starts), provedSumOfCosts(problem, kWhatever, enough()));
}

}  // namespace
}  // namespace sylph
