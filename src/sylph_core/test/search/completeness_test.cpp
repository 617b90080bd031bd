#include <gtest/gtest.h>

#include <algorithm>

#include "joint_search.hpp"
#include "sylph_core/grid/components.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {
namespace {

int drawInt(Rng& rng, int low, int high) {
  return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1));
}

// A crowded instance on a map of up to 3 x 4 cells, most of which are solvable, many only just.
Instance crowdedInstance(Rng& rng, bool rotations) {
  while (true) {
    Instance instance{Grid(drawInt(rng, 1, 3), drawInt(rng, 2, 4)), {}, {}, {rotations}};
    for (int index = 0; index < instance.grid.size(); ++index) {
      instance.grid.setObstacle(instance.grid.cellAt(index), drawInt(rng, 0, 3) == 0);
    }
    const Components components = connectedComponents(instance.grid);
    if (components.cells.empty() || components.cells.front().size() < 2) {
      continue;
    }
    Configuration cells = components.cells.front();
    const int agents = drawInt(rng, 1, std::min<int>(4, static_cast<int>(cells.size())));
    std::shuffle(cells.begin(), cells.end(), rng);
    instance.starts.assign(cells.begin(), cells.begin() + agents);
    std::shuffle(cells.begin(), cells.end(), rng);
    instance.goals.assign(cells.begin(), cells.begin() + agents);
    return instance;
  }
}

void expectSolvedExactlyIfSolvable(bool rotations) {
  const auto planner = makePlanner("lacam");
  PlanningLimits limits;
  limits.first_solution_only = true;
  limits.time_limit_s = 60.0;
  int solvable_count = 0;
  constexpr int kInstances = 2000;
  for (std::uint32_t seed = 0; seed < kInstances; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance = crowdedInstance(rng, rotations);
    const bool is_solvable = isSolvableByJointSearch(instance);
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
  EXPECT_EQ(2u, result.plan.size());
}

}  // namespace
}  // namespace sylph
