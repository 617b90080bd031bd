#include "sylph_core/search/pibt.hpp"

#include <gtest/gtest.h>

#include "sylph_core/planners/planner.hpp"
#include "sylph_core/search/distance_ranking.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {
namespace {

TEST(PibtTest, PushesWhoIsInTheWay) {
  const Instance instance{Grid(1, 4), {{0, 0}, {0, 1}}, {{0, 3}, {0, 1}}, {}};
  const SearchProblem problem(instance);
  Rng rng(1);
  DistanceRanking ranking(problem.distances, rng);
  Pibt pibt(problem);
  Vertices to = {kNoVertex, kNoVertex};
  ASSERT_TRUE(pibt.step(problem.starts, {0, 1}, ranking, to));
  EXPECT_EQ((Vertices{1, 2}), to);
}

TEST(PibtTest, KeepsToBoundAgents) {
  const Instance instance{Grid(1, 4), {{0, 0}, {0, 1}}, {{0, 3}, {0, 1}}, {}};
  const SearchProblem problem(instance);
  Rng rng(1);
  DistanceRanking ranking(problem.distances, rng);
  Pibt pibt(problem);
  Vertices stays = {kNoVertex, 1};
  ASSERT_TRUE(pibt.step(problem.starts, {0, 1}, ranking, stays));
  EXPECT_EQ((Vertices{0, 1}), stays);
  Vertices swap = {1, 0};
  EXPECT_FALSE(pibt.step(problem.starts, {0, 1}, ranking, swap));
  Vertices collision = {1, 1};
  EXPECT_FALSE(pibt.step(problem.starts, {0, 1}, ranking, collision));
}

TEST(PibtTest, RefusesBoundRingsOnlyWithoutRotations) {
  Instance instance{
      Grid(2, 2), {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {{0, 1}, {1, 1}, {1, 0}, {0, 0}}, {}};
  for (const bool rotations : {false, true}) {
    instance.motion.rotations = rotations;
    const SearchProblem problem(instance);
    Rng rng(1);
    DistanceRanking ranking(problem.distances, rng);
    Pibt pibt(problem);
    Vertices bound = problem.goals;
    EXPECT_EQ(rotations, pibt.step(problem.starts, {0, 1, 2, 3}, ranking, bound));
    Vertices free(4, kNoVertex);
    ASSERT_TRUE(pibt.step(problem.starts, {0, 1, 2, 3}, ranking, free));
    EXPECT_EQ(rotations ? problem.goals : problem.starts, free);
  }
}

TEST(PibtTest, TheSwapRuleLetsTwoAgentsPassInACorridorWithABay) {
  const Instance instance{Grid::fromText(".....\n##.##\n"), {{0, 0}, {0, 4}}, {{0, 4}, {0, 0}}, {}};
  PlanningLimits limits;
  limits.max_steps = 50;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    EXPECT_EQ(Outcome::Solved, makePlanner("pibt")->plan(instance, limits, rng).outcome)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace sylph
