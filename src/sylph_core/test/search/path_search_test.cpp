#include "sylph_core/search/path_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/search/paths.hpp"
#include "sylph_core/search/reservation_table.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {
namespace {

// Legal paths of many agents on a small map, to leave one out and to search it again.
struct CrowdedPlan {
  CrowdedPlan(std::uint32_t seed, bool rotations)
      : rng(seed), instance(draw(rotations, rng)), problem(instance) {
    PlanningLimits limits;
    limits.first_solution_only = true;
    std::vector<Vertices> configurations;
    for (const Configuration& cells : makePlanner("lacam")->plan(instance, limits, rng).plan) {
      configurations.push_back(problem.graph.toVertices(cells));
    }
    paths = pathsOf(configurations);
    horizon = static_cast<int>(configurations.size()) + 5;
  }

  static Instance draw(bool rotations, Rng& rng) {
    Grid grid(4, 5);
    grid.setObstacle({1, 1});
    return randomInstance(grid, 12, {rotations}, rng);
  }

  ReservationTable tableWithout(AgentId agent) const {
    ReservationTable table(problem.graph, instance.motion, instance.agentCount(), horizon);
    for (AgentId other = 0; other < instance.agentCount(); ++other) {
      if (other != agent) {
        table.insert(other, paths[other]);
      }
    }
    return table;
  }

  Configuration at(Timestep timestep) const {
    Vertices vertices;
    for (const VertexPath& path : paths) {
      vertices.push_back(path[std::min<std::size_t>(timestep, path.size() - 1)]);
    }
    return problem.graph.toCells(vertices);
  }

  Rng rng;
  Instance instance;
  SearchProblem problem;
  std::vector<VertexPath> paths;
  int horizon = 0;
};

bool isLegalStep(const CrowdedPlan& crowd, AgentId agent, const Cell& from, const Cell& to,
                 Timestep timestep) {
  Configuration before = crowd.at(timestep);
  Configuration after = crowd.at(timestep + 1);
  before[agent] = from;
  after[agent] = to;
  for (std::size_t other = 0; other < before.size(); ++other) {
    if (static_cast<AgentId>(other) != agent &&
        (after[other] == to || (after[other] == from && before[other] == to))) {
      return false;
    }
  }
  return crowd.instance.motion.rotations || findRotations(before, after).empty();
}

// Breadth-first search over time, cell by cell; -1 if the agent cannot arrive.
Timestep earliestArrival(const CrowdedPlan& crowd, AgentId agent) {
  const Cell goal = crowd.instance.goals[agent];
  Timestep free_from = 0;
  for (Timestep timestep = 0; timestep <= crowd.horizon; ++timestep) {
    const Configuration cells = crowd.at(timestep);
    for (AgentId other = 0; other < crowd.instance.agentCount(); ++other) {
      free_from = other != agent && cells[other] == goal ? timestep + 1 : free_from;
    }
  }
  std::set<Cell> reached = {crowd.instance.starts[agent]};
  for (Timestep timestep = 0; timestep <= crowd.horizon; ++timestep) {
    if (timestep >= free_from && reached.count(goal) > 0) {
      return timestep;
    }
    std::set<Cell> next;
    for (const Cell& from : reached) {
      for (const Action action : kActions) {
        const Cell to = neighbor(from, action);
        if (crowd.instance.grid.isFree(to) && isLegalStep(crowd, agent, from, to, timestep)) {
          next.insert(to);
        }
      }
    }
    reached = next;
  }
  return -1;
}

TEST(PathSearchTest, ArrivesAsEarlyAsAnyLegalPath) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CrowdedPlan crowd(seed, seed % 3 == 0);
    for (AgentId agent = 0; agent < crowd.instance.agentCount(); ++agent) {
      ReservationTable table = crowd.tableWithout(agent);
      PathSearch search(crowd.problem.graph);
      const VertexPath path =
          search.find(table, crowd.problem.starts[agent], crowd.problem.goals[agent], crowd.horizon,
                      Deadline(60.0), crowd.rng);
      const Timestep expected = earliestArrival(crowd, agent);
      ASSERT_EQ(expected, static_cast<Timestep>(path.size()) - 1);
      std::vector<VertexPath> paths = crowd.paths;
      paths[agent] = path;
      const auto violation = checkPlan(crowd.instance, crowd.problem.graph.toPlan(planOf(paths)));
      ASSERT_FALSE(violation.has_value()) << violation->message;
      EXPECT_TRUE(search
                      .find(table, crowd.problem.starts[agent], crowd.problem.goals[agent],
                            expected - 1, Deadline(60.0), crowd.rng)
                      .empty());
    }
  }
}

TEST(PathSearchTest, WideMapsTakeSeveralWordsARow) {
  for (const int cols : {62, 63, 64, 127, 128, 200}) {
    const Instance instance{Grid(2, cols), {{0, 0}}, {{1, cols - 1}}, {}};
    const SearchProblem problem(instance);
    ReservationTable table(problem.graph, instance.motion, 1, 2 * cols);
    Rng rng(1);
    const VertexPath path =
        PathSearch(problem.graph)
            .find(table, problem.starts[0], problem.goals[0], 2 * cols, Deadline(60.0), rng);
    EXPECT_EQ(static_cast<std::size_t>(cols + 1), path.size());
  }
}

TEST(ReservationTableTest, AnAgentThatIsTakenOutLeavesNoTrace) {
  const CrowdedPlan crowd(5, false);
  const ReservationTable without = crowd.tableWithout(3);
  ReservationTable table = crowd.tableWithout(3);
  table.insert(3, crowd.paths[3]);
  EXPECT_EQ(3, table.occupant(crowd.problem.starts[3], 0));
  EXPECT_EQ(table.horizon() + 1, table.freeFrom(crowd.problem.goals[3]));
  table.remove(3);
  const int words = 5 * table.layout().words;
  for (Timestep timestep = 0; timestep <= table.horizon(); ++timestep) {
    EXPECT_TRUE(std::equal(table.closed(timestep), table.closed(timestep) + words,
                           without.closed(timestep)));
    for (VertexId vertex = 0; vertex < crowd.problem.graph.size(); ++vertex) {
      EXPECT_EQ(without.occupant(vertex, timestep), table.occupant(vertex, timestep));
    }
  }
}

TEST(ReservationTableTest, NamesTheArrivalThatClosesARing) {
  const Graph graph(Grid(2, 2));
  const VertexPath last = {2, 2, 0};  // (1,0) -> (0,0) at timestep 2
  for (const bool rotations : {false, true}) {
    ReservationTable table(graph, {rotations}, 4, 3);
    table.insert(0, {0, 0, 1});
    table.insert(1, {1, 1, 3});
    table.insert(2, {3, 3, 2});
    EXPECT_EQ(rotations ? 0 : 2, table.rotationClosedBy(last));
  }
}

}  // namespace
}  // namespace sylph
