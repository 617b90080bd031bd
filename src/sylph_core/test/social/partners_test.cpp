#include "sylph_core/social/partners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/random_instance.hpp"

namespace sylph {
namespace {

std::vector<DistanceField> fieldsOf(const Instance& instance) {
  return distancesTo(instance.goals, instance.grid);
}

DistanceToGoal distanceIn(const std::vector<DistanceField>& fields) {
  return [&fields](AgentId agent, const Cell& cell) {
    return fields[static_cast<std::size_t>(agent)].at(cell);
  };
}

/// O_L of Alg. 1, word by word and slow: every pair of agents, every pair of cells.
std::vector<std::vector<double>> overlapsByDefinition(const std::vector<DistanceField>& fields,
                                                      const Configuration& cells) {
  std::vector<std::vector<Cell>> paths;
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    paths.push_back(shortestPath(fields[agent], cells[agent]));
  }
  const auto flowAt = [&](std::size_t agent, std::size_t index) {
    const std::vector<Cell>& path = paths[agent];
    return index + 1 < path.size() ? *actionBetween(path[index], path[index + 1]) : Action::Stay;
  };
  std::vector<std::vector<double>> overlaps(cells.size(), std::vector<double>(cells.size(), 0.0));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < cells.size(); ++j) {
      for (std::size_t at_i = 0; i != j && at_i < paths[i].size(); ++at_i) {
        for (std::size_t at_j = 0; at_j < paths[j].size(); ++at_j) {
          if (paths[i][at_i] == paths[j][at_j] && flowAt(i, at_i) != flowAt(j, at_j)) {
            overlaps[i][j] += std::pow(0.95, at_i) + std::pow(0.95, at_j);
          }
        }
      }
    }
  }
  return overlaps;
}

/// Whether Alg. 1 may choose this partner; overlaps that differ by rounding alone count as equal.
void expectTemporary(const std::vector<double>& row, AgentId agent, AgentId chosen) {
  const double largest = *std::max_element(row.begin(), row.end());
  if (largest == 0.0) {
    EXPECT_EQ(agent, chosen);
    return;
  }
  const auto lowest = std::find_if(row.begin(), row.end(),
                                   [&](double overlap) { return overlap > largest - 1e-9; });
  EXPECT_EQ(lowest - row.begin(), chosen);
}

Configuration randomStep(const Instance& instance, const std::vector<DistanceField>& fields,
                         const Configuration& cells, Rng& rng) {
  Configuration next = cells;
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    const std::vector<Cell> path = shortestPath(fields[agent], cells[agent]);
    const bool follows = path.size() > 1 && drawFraction(rng) < 0.7;
    const Cell desired =
        follows ? path[1] : neighbor(cells[agent], kActions[drawIndex(rng, kActions.size())]);
    if (instance.grid.isFree(desired) && std::count(next.begin(), next.end(), desired) == 0) {
      next[agent] = desired;
    }
  }
  return next;
}

TEST(PartnersProperty, EqualTheAlgorithmsAsWritten) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Grid grid = seed % 2 == 0 ? randomMap({10, 12, 0.2}, rng) : mazeMap({11, 9, 1, 0.2}, rng);
    const int agents = 1 + static_cast<int>(drawIndex(rng, 14));
    const Instance instance = randomInstance(grid, agents, {}, rng);
    const std::vector<DistanceField> fields = fieldsOf(instance);
    Configuration cells = instance.starts;
    Partners partners(instance.grid, distanceIn(fields), cells);
    std::vector<AgentId> fixed = partners.fixed();
    for (int step = 0; step < 25; ++step) {
      const auto overlaps = overlapsByDefinition(fields, cells);
      for (AgentId i = 0; i < agents; ++i) {
        const std::vector<double>& row = overlaps[static_cast<std::size_t>(i)];
        expectTemporary(row, i, partners.temporary(i));
        for (AgentId j = 0; j < agents; ++j) {
          EXPECT_NEAR(row[static_cast<std::size_t>(j)], partners.overlap(i, j), 1e-9);
        }
        AgentId& partner = fixed[static_cast<std::size_t>(i)];
        if (step == 0 || row[static_cast<std::size_t>(partner)] == 0.0) {
          partner = partners.temporary(i);
        }
      }
      EXPECT_EQ(fixed, partners.fixed());
      cells = randomStep(instance, fields, cells, rng);
      partners.update(cells);
    }
  }
}

TEST(PartnersTest, AgentsThatMeetHeadOnArePartners) {
  const Instance instance{
      Grid::fromText("....\n....\n"), {{0, 0}, {0, 3}, {1, 0}}, {{0, 3}, {0, 0}, {1, 1}}, {}};
  const std::vector<DistanceField> fields = fieldsOf(instance);
  const Partners partners(instance.grid, distanceIn(fields), instance.starts);
  EXPECT_EQ((std::vector<AgentId>{1, 0, 2}), partners.fixed());  // nobody crosses agent 2
  // Four cells, met by the one at index k and by the other at index 3 - k.
  EXPECT_NEAR(2.0 * (1.0 + 0.95 + 0.95 * 0.95 + 0.95 * 0.95 * 0.95), partners.overlap(0, 1), 1e-9);
}

TEST(PartnersTest, AgentsThatFollowEachOtherAreNot) {
  const Instance instance{Grid(1, 5), {{0, 0}, {0, 1}}, {{0, 3}, {0, 4}}, {}};
  const std::vector<DistanceField> fields = fieldsOf(instance);
  const Partners partners(instance.grid, distanceIn(fields), instance.starts);
  // Agent 0's goal alone is crossed: there its own flow is none.
  EXPECT_NEAR(std::pow(0.95, 3) + std::pow(0.95, 2), partners.overlap(0, 1), 1e-9);
  EXPECT_EQ(0.0, partners.overlap(0, 0));
}

TEST(PartnersTest, EqualOverlapsGoToTheLowestIndex) {
  // Agents 1 and 2 cross the row of agent 0 at the same cell after the same number of steps.
  const Instance instance{Grid(3, 3), {{1, 0}, {0, 1}, {2, 1}}, {{1, 2}, {2, 1}, {0, 1}}, {}};
  const std::vector<DistanceField> fields = fieldsOf(instance);
  const Partners partners(instance.grid, distanceIn(fields), instance.starts);
  EXPECT_NEAR(2.0 * 0.95, partners.overlap(0, 1), 1e-9);
  EXPECT_EQ(partners.overlap(0, 1), partners.overlap(0, 2));
  EXPECT_EQ(1, partners.temporary(0));
}

TEST(PartnersTest, RefusesAnotherNumberOfAgents) {
  const Instance instance{Grid(1, 5), {{0, 0}, {0, 1}}, {{0, 3}, {0, 4}}, {}};
  const std::vector<DistanceField> fields = fieldsOf(instance);
  Partners partners(instance.grid, distanceIn(fields), instance.starts);
  EXPECT_THROW(partners.update({{0, 0}}), std::invalid_argument);
}

TEST(PartnersAlongPlanTest, GivesOneStatePerJointActionAndNoSvo) {
  const Instance instance{Grid::fromText("...\n...\n"), {{0, 0}, {0, 2}}, {{0, 2}, {0, 0}}, {}};
  const std::vector<DistanceField> fields = fieldsOf(instance);
  const Plan plan = {
      {{0, 0}, {0, 2}}, {{0, 1}, {1, 2}}, {{0, 2}, {1, 1}}, {{0, 2}, {1, 0}}, {{0, 2}, {0, 0}}};
  const auto states = partnersAlongPlan(instance.grid, distanceIn(fields), plan);
  ASSERT_EQ(4U, states.size());
  EXPECT_EQ((std::vector<AgentId>{1, 0}), states[0].partners);
  EXPECT_EQ((std::vector<AgentId>{0, 1}), states[3].partners);  // past each other
  for (const SocialState& state : states) {
    ASSERT_EQ(2U, state.svo_deg.size());
    EXPECT_TRUE(std::isnan(state.svo_deg[0]));
  }
  EXPECT_TRUE(partnersAlongPlan(instance.grid, distanceIn(fields), {instance.starts}).empty());
}

TEST(PartnersAlongPlanTest, GivesTheFirstStatesWhereItIsBrokenOff) {
  const Instance instance{Grid(1, 9), {{0, 0}}, {{0, 8}}, {}};
  const std::vector<DistanceField> fields = fieldsOf(instance);
  Plan plan;
  for (int col = 0; col <= 8; ++col) {
    plan.push_back({{0, col}});
  }
  for (std::size_t most = 0; most <= 9; ++most) {
    std::size_t questions = 0;
    const auto isOver = [&] { return questions++ == most; };
    const auto states = partnersAlongPlan(instance.grid, distanceIn(fields), plan, isOver);
    EXPECT_EQ(std::min<std::size_t>(most, 8), states.size());
  }
}

}  // namespace
}  // namespace sylph
