#include "sylph_training/worlds/environment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/social/svo.hpp"
#include "sylph_training/worlds/collisions.hpp"

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::AgentId;
using sylph::Cell;
using sylph::Configuration;
using sylph::Grid;
using sylph::Rng;

sylph::Instance instanceOf(const std::string& map, Configuration starts, Configuration goals) {
  return {Grid::fromText(map), std::move(starts), std::move(goals), {}};
}

sylph::Instance randomWorld(Rng& rng) {
  const int rows = 4 + static_cast<int>(sylph::drawIndex(rng, 7));
  const int cols = 4 + static_cast<int>(sylph::drawIndex(rng, 7));
  const Grid grid = sylph::drawIndex(rng, 2) == 0 ? sylph::randomMap({rows, cols, 0.3}, rng)
                                                  : sylph::mazeMap({rows, cols, 1, 0.1}, rng);
  const int agents = 1 + static_cast<int>(sylph::drawIndex(
                             rng, std::min<std::size_t>(12, grid.freeCells().size() / 2)));
  return randomInstance(grid, agents, {sylph::drawIndex(rng, 2) == 0}, rng);
}

std::vector<float> randomSvos(std::size_t count, Rng& rng) {
  std::vector<float> svo_deg;
  for (std::size_t agent = 0; agent < count; ++agent) {
    svo_deg.push_back(static_cast<float>(
        sylph::svoOfLevel(static_cast<int>(sylph::drawIndex(rng, sylph::kSvoLevelCount)))));
  }
  return svo_deg;
}

/// Mostly downhill, so that agents reach their goals and meet on the way.
std::vector<Action> randomActions(const Environment& world, Rng& rng) {
  std::vector<Action> desired;
  for (AgentId agent = 0; agent < world.instance().agentCount(); ++agent) {
    const auto index = static_cast<std::size_t>(agent);
    const auto path =
        shortestPath(sylph::DistanceField(world.instance().grid, world.instance().goals[index]),
                     world.cells()[index]);
    const Action downhill =
        path.size() > 1 ? *sylph::actionBetween(path[0], path[1]) : Action::Stay;
    desired.push_back(sylph::drawIndex(rng, 4) == 0
                          ? sylph::kActions[sylph::drawIndex(rng, sylph::kActionCount)]
                          : downhill);
  }
  return desired;
}

/// Breadth first among free cells that are not in `taken`.
std::optional<int> distanceAmong(const Grid& grid, const Cell& from, const Cell& to,
                                 const Configuration& taken) {
  std::map<Cell, int> distance = {{from, 0}};
  std::deque<Cell> open = {from};
  while (!open.empty()) {
    const Cell cell = open.front();
    open.pop_front();
    if (cell == to) {
      return distance.at(cell);
    }
    for (const Action action : sylph::kActions) {
      const Cell next = neighbor(cell, action);
      if (grid.isFree(next) && std::find(taken.begin(), taken.end(), next) == taken.end() &&
          distance.emplace(next, distance.at(cell) + 1).second) {
        open.push_back(next);
      }
    }
  }
  return std::nullopt;
}

/// The definition word for word, two searches for each pair.
int literalBlockedCount(const sylph::Instance& world, const Configuration& cells, std::size_t i,
                        int detour_cells) {
  if (cells[i] != world.goals[i]) {
    return 0;
  }
  const auto isInView = [&](std::size_t j) {
    return std::abs(cells[j].row - cells[i].row) <= 4 && std::abs(cells[j].col - cells[i].col) <= 4;
  };
  int blocked = 0;
  for (std::size_t j = 0; j < cells.size(); ++j) {
    if (j == i || !isInView(j)) {
      continue;
    }
    Configuration others;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (k != i && k != j && isInView(k)) {
        others.push_back(cells[k]);
      }
    }
    const auto without = distanceAmong(world.grid, cells[j], world.goals[j], others);
    others.push_back(cells[i]);
    const auto with = distanceAmong(world.grid, cells[j], world.goals[j], others);
    blocked += without && (!with || *with > *without + detour_cells) ? 1 : 0;
  }
  return blocked;
}

TEST(BlockingTest, AgreesWithTheDefinitionInRandomCrowds) {
  int blocked_at_all = 0;
  for (unsigned seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const sylph::Instance world = randomWorld(rng);
    std::vector<sylph::DistanceField> distances;
    for (const Cell& goal : world.goals) {
      distances.emplace_back(world.grid, goal);
    }
    // Every second agent on its goal, the others where they start if that is not taken.
    Configuration cells = world.goals;
    for (std::size_t agent = 0; agent < cells.size(); agent += 2) {
      if (std::find(cells.begin(), cells.end(), world.starts[agent]) == cells.end()) {
        cells[agent] = world.starts[agent];
      }
    }
    for (const int detour_cells : {0, 3, 4, 10}) {
      BlockingTest blocking(world.grid, distances, detour_cells);
      const std::vector<int> counted = blocking.count(cells);
      for (std::size_t agent = 0; agent < cells.size(); ++agent) {
        ASSERT_EQ(literalBlockedCount(world, cells, agent, detour_cells), counted[agent])
            << "agent " << agent << ", detour " << detour_cells;
        blocked_at_all += counted[agent];
      }
    }
  }
  EXPECT_GT(blocked_at_all, 100);
}

void expectRewards(const sylph::Instance& world, const Configuration& before,
                   const Configuration& after, const std::vector<AgentId>& partners,
                   const std::vector<float>& svo_deg, const StepOutcome& outcome) {
  std::vector<double> external;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (outcome.is_penalized[i]) {
      external.push_back(-2.0);
    } else if (before[i] != after[i] || after[i] != world.goals[i]) {
      external.push_back(-0.3);
    } else {
      external.push_back(-1.0 * literalBlockedCount(world, after, i, 10));
    }
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double own = external[i];
    const double other = external[static_cast<std::size_t>(partners[i])];
    const double angle = svo_deg[i] * M_PI / 180.0;
    EXPECT_NEAR(own, outcome.external_rewards[i], 1e-12);
    EXPECT_NEAR((own + other) / 2.0, outcome.social_rewards[i], 1e-12);
    EXPECT_NEAR(std::cos(angle) * own + std::sin(angle) * other, outcome.action_rewards[i], 1e-6);
  }
}

TEST(EnvironmentProperty, NobodyCollidesAndRewardsAreThoseOfTheTable) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const sylph::Instance instance = randomWorld(rng);
    EnvironmentOptions options;
    options.tie_breaking = seed % 2 == 0;
    options.max_steps = 40;
    const std::size_t agents = instance.starts.size();
    Environment world(instance, options, randomSvos(agents, rng));
    sylph::Plan plan = {world.cells()};
    while (!world.isFinished()) {
      const std::vector<AgentId> partners = world.partners();
      const std::vector<float> svo_deg = randomSvos(agents, rng);
      const StepOutcome outcome =
          world.step(randomActions(world, rng), {randomSvos(agents, rng), svo_deg});
      expectRewards(instance, plan.back(), world.cells(), partners, svo_deg, outcome);
      plan.push_back(world.cells());
    }
    for (std::size_t step = 1; step < plan.size(); ++step) {
      const sylph::Instance part{instance.grid, plan[step - 1], plan[step], instance.motion};
      const auto violation = checkPlan(part, {plan[step - 1], plan[step]});
      ASSERT_FALSE(violation) << violation->message;
    }
    EXPECT_TRUE(world.isSolved() || world.stepCount() == 40);
  }
}

TEST(EnvironmentProperty, TheSameSeedGivesTheSameEpisode) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto run = [&] {
      Rng rng(seed);
      const sylph::Instance instance = randomWorld(rng);
      const std::size_t agents = instance.starts.size();
      Environment world(instance, {}, randomSvos(agents, rng));
      std::vector<double> rewards;
      while (!world.isFinished() && world.stepCount() < 50) {
        const auto desired = randomActions(world, rng);
        const StepOutcome outcome =
            world.step(desired, {randomSvos(agents, rng), randomSvos(agents, rng)});
        rewards.insert(rewards.end(), outcome.action_rewards.begin(), outcome.action_rewards.end());
      }
      return std::pair(world.cells(), rewards);
    };
    EXPECT_EQ(run(), run());
  }
}

TEST(EnvironmentTest, OneThatRestsOnItsGoalInACorridorPaysForWhoCannotPass) {
  // Agent 0 stands on its goal, agent 1 has to pass.
  Environment world(instanceOf(".....\n", {{0, 2}, {0, 0}}, {{0, 2}, {0, 4}}), {}, {0.F, 0.F});
  EXPECT_EQ((std::vector<int>{1, 0}), world.blockedCounts());
  const StepOutcome outcome = world.step({Action::Stay, Action::Stay}, {{0.F, 45.F}, {0.F, 45.F}});
  EXPECT_EQ((std::vector<double>{-1.0, -0.3}), outcome.external_rewards);
  EXPECT_EQ((std::vector<double>{-0.65, -0.65}), outcome.social_rewards);
  EXPECT_NEAR(-1.0, outcome.action_rewards[0], 1e-12);
  EXPECT_NEAR(-1.3 * std::sqrt(0.5), outcome.action_rewards[1], 1e-12);
}

TEST(EnvironmentTest, AMeanBySvoLeavesEqualRewardsAsTheyAre) {
  EnvironmentOptions options;
  options.rewards.mean_by_svo = true;
  const sylph::Instance blocked = instanceOf(".....\n", {{0, 2}, {0, 0}}, {{0, 2}, {0, 4}});
  Environment world(blocked, options, {0.F, 0.F});
  const StepOutcome halves = world.step({Action::Stay, Action::Stay}, {{0.F, 0.F}, {45.F, 45.F}});
  EXPECT_NEAR(-0.65, halves.action_rewards[0], 1e-6);  // of -1 and -0.3
  EXPECT_NEAR(-0.65, halves.action_rewards[1], 1e-6);
  const StepOutcome own = world.step({Action::Stay, Action::Stay}, {{0.F, 0.F}, {0.F, 0.F}});
  EXPECT_EQ(own.external_rewards, own.action_rewards);
  options.partners = false;
  Environment alone(blocked, options, {0.F, 0.F});
  const StepOutcome step = alone.step({Action::Stay, Action::Stay}, {{0.F, 0.F}, {45.F, 20.F}});
  EXPECT_NEAR(-1.0, step.action_rewards[0], 1e-6);
  EXPECT_NEAR(-0.3, step.action_rewards[1], 1e-6);
}

TEST(EnvironmentTest, TheMoreProsocialYieldsUnderTieBreakingAndBothStayWithout) {
  const sylph::Instance crossing =
      instanceOf("#.#\n...\n#.#\n", {{1, 0}, {0, 1}}, {{1, 2}, {2, 1}});
  Environment social(crossing, {}, {0.F, 0.F});
  const StepOutcome yielded =
      social.step({Action::East, Action::South}, {{45.F, 0.F}, {45.F, 0.F}});
  EXPECT_EQ((Configuration{{1, 0}, {1, 1}}), social.cells());
  EXPECT_EQ((std::vector<double>{-2.0, -0.3}), yielded.external_rewards);

  EnvironmentOptions options;
  options.tie_breaking = false;
  Environment selfish(crossing, options, {0.F, 0.F});
  const StepOutcome halted =
      selfish.step({Action::East, Action::South}, {{45.F, 0.F}, {45.F, 0.F}});
  EXPECT_EQ(crossing.starts, selfish.cells());
  EXPECT_EQ((std::vector<double>{-2.0, -2.0}), halted.external_rewards);
}

TEST(EnvironmentTest, WithoutPartnersRewardsAreOnesOwn) {
  EnvironmentOptions options;
  options.partners = false;
  Environment world(instanceOf(".....\n", {{0, 2}, {0, 0}}, {{0, 2}, {0, 4}}), options, {0.F, 0.F});
  EXPECT_EQ((std::vector<AgentId>{0, 1}), world.partners());
  const StepOutcome outcome = world.step({Action::Stay, Action::Stay}, {{0.F, 0.F}, {0.F, 0.F}});
  EXPECT_EQ(outcome.external_rewards, outcome.social_rewards);
  EXPECT_EQ(outcome.external_rewards, outcome.action_rewards);
  EXPECT_EQ(0.0, world.partnerOverlap(0));
}

TEST(EnvironmentTest, EndsWhenAllHaveArrivedAndTakesNoStepAfterwards) {
  Environment world(instanceOf("...\n...\n", {{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}), {}, {0.F, 0.F});
  EXPECT_FALSE(world.isFinished());
  world.step({Action::East, Action::East}, {{0.F, 0.F}, {0.F, 0.F}});
  EXPECT_TRUE(world.isSolved());
  EXPECT_TRUE(world.isFinished());
  EXPECT_THROW(world.step({Action::Stay, Action::Stay}, {{0.F, 0.F}, {0.F, 0.F}}),
               std::logic_error);
}

TEST(EnvironmentTest, RefusesWhatItCannotBeAsked) {
  const sylph::Instance instance = instanceOf("...\n", {{0, 0}}, {{0, 2}});
  EXPECT_THROW(Environment(instance, {}, {}), std::invalid_argument);
  EnvironmentOptions options;
  options.max_steps = 0;
  EXPECT_THROW(Environment(instance, options, {0.F}), std::invalid_argument);
  options.max_steps = 1;
  options.rewards.blocking_detour_cells = -1;
  EXPECT_THROW(Environment(instance, options, {0.F}), std::invalid_argument);
  Environment world(instance, {}, {0.F});
  EXPECT_THROW(world.step({}, {{0.F}, {0.F}}), std::invalid_argument);
  EXPECT_THROW(world.step({Action::Stay}, {{0.F}, {}}), std::invalid_argument);
  EXPECT_THROW(world.step({Action::Stay}, {{}, {0.F}}), std::invalid_argument);
  EXPECT_THROW(haltCollisions(instance.grid, {}, {{0, 0}}, {}), std::invalid_argument);
}

TEST(HaltCollisionsTest, StopsSwapsAndRingsButNotWhoFollows) {
  const Grid open(2, 2);
  const Configuration square = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const std::vector<Action> round = {Action::East, Action::South, Action::West, Action::North};
  EXPECT_EQ(round, haltCollisions(open, {true}, square, round).actions);
  EXPECT_EQ(std::vector<Action>(4, Action::Stay),
            haltCollisions(open, {false}, square, round).actions);

  const Grid corridor(1, 4);
  const auto swap =
      haltCollisions(corridor, {true}, {{0, 0}, {0, 1}}, {Action::East, Action::West});
  EXPECT_EQ(std::vector<Action>(2, Action::Stay), swap.actions);
  EXPECT_EQ(std::vector<bool>(2, true), swap.is_penalized);
  const auto follow =
      haltCollisions(corridor, {false}, {{0, 0}, {0, 1}}, {Action::East, Action::East});
  EXPECT_EQ(std::vector<Action>(2, Action::East), follow.actions);
  EXPECT_EQ(std::vector<bool>(2, false), follow.is_penalized);
}

}  // namespace
}  // namespace sylph_training
