#include "sylph_core/social/tie_breaking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <stdexcept>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

struct World {
  Grid grid;
  MotionModel motion;
  Configuration cells;
  std::vector<Action> desired;
  std::vector<float> svo_deg;
};

int draw(Rng& rng, int bound) {
  return static_cast<int>(drawIndex(rng, static_cast<std::size_t>(bound)));
}

World randomWorld(Rng& rng) {
  World world;
  world.grid = Grid(2 + draw(rng, 5), 2 + draw(rng, 5));
  for (const Cell& cell : world.grid.freeCells()) {
    world.grid.setObstacle(cell, draw(rng, 5) == 0);
  }
  world.motion.rotations = draw(rng, 2) == 0;
  world.cells = world.grid.freeCells();
  shuffle(world.cells, rng);
  world.cells.resize(static_cast<std::size_t>(draw(rng, static_cast<int>(world.cells.size()) + 1)));
  for (std::size_t agent = 0; agent < world.cells.size(); ++agent) {
    world.desired.push_back(kActions[static_cast<std::size_t>(draw(rng, kActionCount))]);
    world.svo_deg.push_back(static_cast<float>(svoOfLevel(draw(rng, kSvoLevelCount))));
  }
  return world;
}

TieBreaking breakTies(const World& world) {
  return breakTies(world.grid, world.motion, world.cells, world.desired, world.svo_deg);
}

Configuration reached(const World& world, const std::vector<Action>& actions) {
  Configuration cells;
  for (std::size_t agent = 0; agent < actions.size(); ++agent) {
    cells.push_back(neighbor(world.cells[agent], actions[agent]));
  }
  return cells;
}

bool isInRotation(const World& world, const std::vector<Action>& actions, std::size_t agent) {
  const auto rotations = findRotations(world.cells, reached(world, actions));
  return std::any_of(rotations.begin(), rotations.end(), [&](const auto& rotation) {
    return std::find(rotation.begin(), rotation.end(), static_cast<AgentId>(agent)) !=
           rotation.end();
  });
}

/// Alg. 3 line by line, everything looked up anew by comparing all pairs.
TieBreaking literalAlgorithm3(const World& world) {
  const std::size_t count = world.cells.size();
  std::vector<Action> actions = world.desired;
  std::vector<bool> penalized(count, false);
  std::deque<std::size_t> chain;
  for (std::size_t agent = 0; agent < count; ++agent) {
    const auto position = std::find_if(chain.begin(), chain.end(), [&](std::size_t other) {
      return world.svo_deg[other] < world.svo_deg[agent];
    });
    chain.insert(position, agent);
  }
  const auto causes = [&](std::size_t i) {  // every j that makes i's action a restricted one
    const Configuration next = reached(world, actions);
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j < count; ++j) {
      const bool swaps = next[i] == world.cells[j] && next[j] == world.cells[i];
      if (j != i && (next[j] == next[i] || swaps)) {
        found.push_back(j);
      }
    }
    return found;
  };
  const auto stay = [&](std::size_t i) {
    actions[i] = Action::Stay;
    for (const std::size_t j : causes(i)) {
      if (std::find(chain.begin(), chain.end(), j) == chain.end()) {
        chain.push_back(j);
      }
    }
  };
  while (!chain.empty()) {
    const std::size_t i = chain.front();
    chain.pop_front();
    const std::vector<std::size_t> restricting = causes(i);
    const bool rotates = isInRotation(world, actions, i);
    // NOLINTNEXTLINE(bugprone-branch-clone): the order of the algorithm's lines
    if (!world.grid.isFree(neighbor(world.cells[i], actions[i]))) {
      penalized[i] = true;
      stay(i);
    } else if (!restricting.empty()) {
      for (const std::size_t j : restricting) {
        penalized[i] = penalized[i] || world.svo_deg[i] >= world.svo_deg[j];
        penalized[j] = penalized[j] || world.svo_deg[j] >= world.svo_deg[i];
      }
      stay(i);
    } else if (rotates && !world.motion.rotations) {
      penalized[i] = true;
      stay(i);
    }
  }
  return {actions, penalized};
}

TEST(BreakTiesProperty, ResultIsFreeOfConflictsAndOnlyStops) {
  for (std::uint32_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const World world = randomWorld(rng);
    const TieBreaking result = breakTies(world);
    for (std::size_t agent = 0; agent < world.cells.size(); ++agent) {
      ASSERT_TRUE(result.actions[agent] == world.desired[agent] ||
                  result.actions[agent] == Action::Stay);
    }
    const Configuration next = reached(world, result.actions);
    const Instance instance{world.grid, world.cells, next, world.motion};
    const auto violation = checkPlan(instance, {world.cells, next});
    ASSERT_FALSE(violation.has_value()) << violation->message;
  }
}

TEST(BreakTiesProperty, EqualsTheLiteralAlgorithm) {
  for (std::uint32_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const World world = randomWorld(rng);
    const TieBreaking expected = literalAlgorithm3(world);
    const TieBreaking result = breakTies(world);
    ASSERT_EQ(expected.actions, result.actions);
    ASSERT_EQ(expected.is_penalized, result.is_penalized);
  }
}

TEST(BreakTiesTest, TheMoreProsocialYieldsAndIsPenalised) {
  const World world{Grid(1, 3), {}, {{0, 0}, {0, 2}}, {Action::East, Action::West}, {10.F, 30.F}};
  const TieBreaking result = breakTies(world);
  EXPECT_EQ((std::vector<Action>{Action::East, Action::Stay}), result.actions);
  EXPECT_EQ((std::vector<bool>{false, true}), result.is_penalized);
}

TEST(BreakTiesTest, OfEqualsBothArePenalisedAndTheLowerIndexYields) {
  const World world{Grid(1, 3), {}, {{0, 0}, {0, 2}}, {Action::East, Action::West}, {20.F, 20.F}};
  const TieBreaking result = breakTies(world);
  EXPECT_EQ((std::vector<Action>{Action::Stay, Action::West}), result.actions);
  EXPECT_EQ((std::vector<bool>{true, true}), result.is_penalized);
}

TEST(BreakTiesTest, AQueueStopsBehindAWall) {
  const World world{Grid(1, 3),
                    {},
                    {{0, 0}, {0, 1}, {0, 2}},
                    {Action::East, Action::East, Action::East},
                    {0.F, 20.F, 40.F}};
  const TieBreaking result = breakTies(world);
  EXPECT_EQ(std::vector<Action>(3, Action::Stay), result.actions);
  EXPECT_TRUE(result.is_penalized[2]);
}

TEST(BreakTiesTest, ARingTurnsOnlyWithRotations) {
  World world{Grid(2, 2),
              MotionModel{true},
              {{0, 0}, {0, 1}, {1, 1}, {1, 0}},
              {Action::East, Action::South, Action::West, Action::North},
              {0.F, 5.F, 45.F, 10.F}};
  EXPECT_EQ(world.desired, breakTies(world).actions);
  world.motion.rotations = false;
  const TieBreaking result = breakTies(world);
  EXPECT_EQ(std::vector<Action>(4, Action::Stay), result.actions);
  EXPECT_TRUE(result.is_penalized[2]);
}

TEST(BreakTiesTest, RefusesSizesThatDiffer) {
  EXPECT_THROW(sylph::breakTies(Grid(1, 2), {}, {{0, 0}}, {}, {0.F}), std::invalid_argument);
  EXPECT_THROW(
      sylph::breakTies(Grid(1, 2), {}, {{0, 0}, {0, 0}}, {Action::Stay, Action::Stay}, {0.F, 0.F}),
      std::invalid_argument);
}

}  // namespace
}  // namespace sylph
