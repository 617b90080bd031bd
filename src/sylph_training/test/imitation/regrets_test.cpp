#include "sylph_training/imitation/regrets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_training/imitation/demonstration.hpp"

namespace sylph_training {
namespace {

constexpr int kNever = std::numeric_limits<int>::max() / 2;

bool isLegal(const sylph::Instance& instance, const sylph::Plan& plan) {
  sylph::Instance from_here = instance;
  from_here.starts = plan.front();
  const auto violation = sylph::checkPlan(from_here, plan);
  return !violation || violation->kind == sylph::ViolationKind::GoalNotReached;
}

/// Least cost to come of an agent from the first configuration of a plan, by trying everything.
int leastCost(const sylph::Instance& instance, const sylph::SearchProblem& problem,
              const sylph::Plan& plan, std::size_t agent, std::size_t timestep) {
  if (timestep + 1 == plan.size()) {
    return problem.distances.get(static_cast<sylph::AgentId>(agent),
                                 problem.graph.vertexAt(plan.back()[agent]));
  }
  int least = kNever;
  for (const sylph::Action action : sylph::kActions) {
    sylph::Plan changed = plan;
    const sylph::Cell at = plan[timestep][agent];
    changed[timestep + 1][agent] = sylph::neighbor(at, action);
    if (!isLegal(instance, {changed[timestep], changed[timestep + 1]})) {
      continue;
    }
    const bool rests =
        at == instance.goals[agent] && changed[timestep + 1][agent] == instance.goals[agent];
    least = std::min(least,
                     leastCost(instance, problem, changed, agent, timestep + 1) + (rests ? 0 : 1));
  }
  return least;
}

Regrets bruteForce(const sylph::Instance& instance, const sylph::SearchProblem& problem,
                   const sylph::Plan& plan, std::size_t agent) {
  std::array<int, sylph::kActionCount> costs{};
  for (const sylph::Action action : sylph::kActions) {
    sylph::Plan changed = plan;
    const sylph::Cell at = plan[0][agent];
    changed[1][agent] = sylph::neighbor(at, action);
    const bool rests = at == instance.goals[agent] && action == sylph::Action::Stay;
    costs[static_cast<std::size_t>(action)] =
        isLegal(instance, {changed[0], changed[1]})
            ? std::min(kNever, leastCost(instance, problem, changed, agent, 1) + (rests ? 0 : 1))
            : kNever;
  }
  const int best = *std::min_element(costs.begin(), costs.end());
  Regrets regrets{};
  for (std::size_t action = 0; action < costs.size(); ++action) {
    regrets[action] =
        costs[action] == kNever ? kImpossible : static_cast<std::uint8_t>(costs[action] - best);
  }
  return regrets;
}

void expectAsBruteForce(const sylph::MotionModel& motion, std::uint32_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  constexpr std::size_t kSteps = 4;
  sylph::Rng rng(seed);
  sylph::Grid grid(3, 4);
  grid.setObstacle({1, static_cast<int>(seed % 4)}, seed % 3 != 0);
  const sylph::Instance instance = sylph::randomInstance(grid, 6, motion, rng);
  const sylph::SearchProblem problem(instance);
  const auto plan = findExpertPlan(problem, {1.0, 0.002, 1, 1, 1.0}, rng);
  if (!plan || plan->size() < 2) {
    return;
  }
  const std::vector<sylph::Vertices> beginning(
      plan->begin(), plan->begin() + static_cast<long>(std::min(kSteps + 1, plan->size())));
  const RegretTable table(problem, beginning);
  const sylph::Plan cells = problem.graph.toPlan(beginning);
  for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
    const std::vector<Regrets> regrets = table.of(static_cast<sylph::AgentId>(agent));
    ASSERT_EQ(beginning.size() - 1, regrets.size());
    for (std::size_t step = 0; step < regrets.size(); ++step) {
      const sylph::Plan rest(cells.begin() + static_cast<long>(step), cells.end());
      EXPECT_EQ(bruteForce(instance, problem, rest, agent), regrets[step])
          << "agent " << agent << " at step " << step;
    }
  }
}

TEST(RegretTableTest, AgreesWithTryingEverything) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    expectAsBruteForce({false}, seed);
    expectAsBruteForce({true}, seed);
  }
}

TEST(RegretTableTest, WalkingOffCostsTheWayBack) {
  const sylph::Instance instance{sylph::Grid::fromText("...\n.#.\n"), {{0, 0}}, {{0, 2}}, {}};
  const sylph::SearchProblem problem(instance);
  const auto at = [&](int row, int col) { return problem.graph.vertexAt({row, col}); };
  const RegretTable table(problem, {{at(0, 0)}, {at(0, 1)}, {at(0, 2)}, {at(0, 2)}});
  const Regrets start{1, kImpossible, 0, 2, kImpossible};  // stay, north, east, south, west
  const Regrets home{0, kImpossible, kImpossible, 2, 2};
  EXPECT_EQ(start, table.of(0)[0]);
  EXPECT_EQ(home, table.of(0)[2]);
}

}  // namespace
}  // namespace sylph_training
