#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "../search/joint_search.hpp"
#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/policy/policy_rollout.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/policy_generator.hpp"
#include "sylph_core/search/policy_steps.hpp"
#include "sylph_core/social/partners.hpp"
#include "sylph_core/text/join.hpp"
#include "test/support/random_weights.hpp"

namespace sylph {
namespace {

const std::vector<std::string> kPolicyPlanners = {"sylph", "sylph_pibt", "sylph_lacam"};

std::vector<Grid> oneMapOfEachFamily(Rng& rng) {
  RandomMapSpec random;
  random.rows = random.cols = 12;
  RoomMapSpec room;
  room.rows = room.cols = 13;
  room.room_size = 3;
  MazeMapSpec maze;
  maze.rows = maze.cols = 13;
  return {randomMap(random, rng), roomMap(room, rng), mazeMap(maze, rng)};
}

/// One partner and one SVO per agent and step, as the plan shows where agents are.
void expectWellFormed(const Instance& instance, const PlanningResult& result) {
  ASSERT_EQ(result.plan.size() - 1, result.social.size());
  const std::vector<DistanceField> distances = distancesTo(instance.goals, instance.grid);
  const auto distance = [&](AgentId agent, const Cell& cell) {
    return distances[static_cast<std::size_t>(agent)].at(cell);
  };
  const auto expected = partnersAlongPlan(instance.grid, distance, result.plan);
  for (std::size_t step = 0; step < result.social.size(); ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    const SocialState& state = result.social[step];
    EXPECT_EQ(expected[step].partners, state.partners);
    ASSERT_EQ(instance.starts.size(), state.svo_deg.size());
    for (std::size_t agent = 0; agent < instance.starts.size(); ++agent) {
      EXPECT_GE(state.svo_deg[agent], 0.F);
      EXPECT_LE(state.svo_deg[agent], 45.F);
      if (result.plan[step][agent] == instance.goals[agent]) {
        EXPECT_EQ(45.F, state.svo_deg[agent]);
      }
    }
  }
}

class PolicyPlannersTest : public ::testing::TestWithParam<std::string> {
 protected:
  PlanningResult plan(const Instance& instance, std::uint32_t seed,
                      const std::shared_ptr<const Policy>& policy = randomPolicy()) const {
    Rng rng(seed);
    return makePlanner(GetParam(), policy)->plan(instance, limits_, rng);
  }

  PlanningLimits limits_{30.0, 60, true};
};

TEST_P(PolicyPlannersTest, GiveLegalPlansAndSocialStatesOnEveryKindOfMap) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    Rng rng(seed);
    for (const Grid& grid : oneMapOfEachFamily(rng)) {
      SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + grid.toText());
      const Instance instance = randomInstance(grid, 12, MotionModel{seed % 2 == 0}, rng);
      const PlanningResult result = plan(instance, seed);
      const auto violation = checkPlan(instance, result.plan);
      if (violation) {
        EXPECT_NE(Outcome::Solved, result.outcome) << violation->message;
        EXPECT_EQ(ViolationKind::GoalNotReached, violation->kind) << violation->message;
      }
      expectWellFormed(instance, result);
      EXPECT_GE(result.statistics.policy_calls, static_cast<long>(result.social.size()));
    }
  }
}

TEST_P(PolicyPlannersTest, TheSameSeedGivesTheSamePlanWhateverTheThreads) {
  Rng rng(4);
  const Instance instance = randomInstance(oneMapOfEachFamily(rng).front(), 40, {}, rng);
  const PlanningResult first = plan(instance, 9);
  limits_.threads = 3;
  const PlanningResult second = plan(instance, 9);
  EXPECT_EQ(first.plan, second.plan);
  ASSERT_EQ(first.social.size(), second.social.size());
  for (std::size_t step = 0; step < first.social.size(); ++step) {
    EXPECT_EQ(first.social[step].svo_deg, second.social[step].svo_deg);
  }
}

TEST_P(PolicyPlannersTest, CountTheNetworksCalls) {
  const Instance alone{Grid(1, 6), {{0, 0}}, {{0, 5}}, {}};
  const PlanningResult result = plan(alone, 1);
  const long steps = static_cast<long>(result.plan.size()) - 1;
  if (GetParam() == "sylph_lacam") {
    EXPECT_LE(result.statistics.policy_calls, steps + 1);  // comes to the goals' configuration too
  } else {
    EXPECT_EQ(steps, result.statistics.policy_calls);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PolicyPlannersTest, ::testing::ValuesIn(kPolicyPlanners));

TEST(AblationTest, EachGivesLegalPlansUnlikeThoseWithoutIt) {
  Rng rng(4);
  const Instance instance = randomInstance(oneMapOfEachFamily(rng).front(), 40, {}, rng);
  const PlanningLimits limits{30.0, 20, true};
  const auto planBy = [&](const std::string& ablation) {
    Rng own(9);
    return makePlanner("sylph", randomPolicy(), ablation)->plan(instance, limits, own);
  };
  std::set<Plan> plans = {planBy("").plan};
  for (const std::string& ablation : ablationNames()) {
    SCOPED_TRACE(ablation);
    const PlanningResult result = planBy(ablation);
    const auto violation = checkPlan(instance, result.plan);
    EXPECT_TRUE(!violation || violation->kind == ViolationKind::GoalNotReached);
    EXPECT_TRUE(plans.insert(result.plan).second) << "a plan like one of another ablation";
  }
}

TEST(AblationTest, StandsInThePlannersName) {
  EXPECT_EQ("sylph_pibt/svo_by_priority",
            makePlanner("sylph_pibt", randomPolicy(), "svo_by_priority")->name());
  EXPECT_EQ("pibt", makePlanner("pibt", nullptr, "svo_by_priority")->name()) << "it has no SVO";
  try {
    makePlanner("sylph", randomPolicy(), "no_svo");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ("ablation 'no_svo' is unknown: must be one of " + join(ablationNames()),
              std::string(error.what()));
  }
}

// Two ways of the same length lead to the goal.
TEST(CostNetworkTest, IsAskedByPlannersThatSearchAndNotBySylph) {
  const Instance instance{Grid(2, 2), {{0, 0}}, {{1, 1}}, {}};
  TensorFile weights = RandomWeights(smallShape(), 1).file();
  TensorFile cost = weights;
  weights.tensors["heads.action.bias"].values[static_cast<std::size_t>(Action::East)] = 50.F;
  cost.tensors["heads.action.bias"].values[static_cast<std::size_t>(Action::South)] = 50.F;
  const auto policy =
      std::make_shared<const Policy>(withCostNetwork(weights, cost), "opposed networks");
  const auto firstCell = [&](const std::string& planner) {
    Rng rng(1);
    return makePlanner(planner, policy)->plan(instance, {30.0, 60, true}, rng).plan.at(1)[0];
  };
  EXPECT_EQ((Cell{0, 1}), firstCell("sylph"));
  EXPECT_EQ((Cell{1, 0}), firstCell("sylph_pibt"));
}

/// LaCAM by the policy alone, without the planner's search by distance.
Lacam::Status searchByPolicy(const Instance& instance, const Policy& policy, Rng& rng) {
  const SearchProblem problem(instance);
  PolicyRollout rollout(policy, instance.grid, problem.distances.fields(), SvoChoice::Mean, 1, rng);
  PolicySteps steps(rollout, problem.graph, rng);
  PolicyGenerator generator(problem, steps, MoveSettings(), PolicyPatience(), rng);
  Lacam lacam(problem, generator, rng);
  return lacam.search(Deadline(60.0), -1);
}

void expectSolvedExactlyIfSolvable(bool rotations) {
  PlanningLimits limits;
  limits.first_solution_only = true;
  limits.time_limit_s = 60.0;
  int solvable_count = 0;
  constexpr int kInstances = 200;
  for (std::uint32_t seed = 0; seed < kInstances; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // Weights so large that they overrule the distance, other ones for each instance.
    const auto policy = std::make_shared<const Policy>(
        RandomWeights(smallShape(), seed, 5.0).file(), "large weights");
    Rng rng(seed);
    const Instance instance = crowdedInstance(4, rotations, rng);
    const bool is_solvable = leastCostByJointSearch(instance).has_value();
    EXPECT_EQ(is_solvable ? Lacam::Status::Solved : Lacam::Status::Exhausted,
              searchByPolicy(instance, *policy, rng));
    Rng lacam_rng = rng;
    const PlanningResult result = makePlanner("sylph_lacam", policy)->plan(instance, limits, rng);
    ASSERT_EQ(is_solvable ? Outcome::Solved : Outcome::Unsolvable, result.outcome)
        << instance.grid.toText();
    const PlanningResult by_distance = makePlanner("lacam")->plan(instance, limits, lacam_rng);
    EXPECT_EQ(by_distance.outcome, result.outcome);
    if (is_solvable) {
      ++solvable_count;
      const auto violation = checkPlan(instance, result.plan);
      ASSERT_FALSE(violation.has_value()) << violation->message;
      EXPECT_LE(computeMetrics(instance, result.plan).sum_of_costs,
                computeMetrics(instance, by_distance.plan).sum_of_costs);
    }
  }
  EXPECT_GT(solvable_count, kInstances / 4);
  EXPECT_LT(solvable_count, kInstances * 3 / 4);
}

TEST(SylphPibtTest, GoesByDistanceWhereTheNetworkLeadsNoNearer) {
  const TensorFile policy = RandomWeights(smallShape(), 1).file();
  TensorFile cost = policy;
  cost.tensors["heads.action.bias"].values[static_cast<std::size_t>(Action::Stay)] = 1e6F;
  const auto idle = std::make_shared<const Policy>(withCostNetwork(policy, cost), "idle");
  const Instance instance{Grid(8, 8), {{0, 0}, {7, 0}}, {{0, 7}, {7, 7}}, {}};
  PlanningLimits limits;
  limits.max_steps = 300;
  Rng rng(1);
  EXPECT_EQ(Outcome::Solved, makePlanner("sylph_pibt", idle)->plan(instance, limits, rng).outcome);
}

TEST(SylphLacamTest, SolvesExactlyTheSolvableWhateverTheWeightsAndNeverForMoreThanLacam) {
  expectSolvedExactlyIfSolvable(false);
  expectSolvedExactlyIfSolvable(true);
}

}  // namespace
}  // namespace sylph
