#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "random_plan.hpp"
#include "sylph_core/adg/action_dependency_graph.hpp"

namespace sylph {
namespace {

using test::pickOne;
using test::randomPlan;
using test::randomWalk;
using test::uniform;

constexpr std::uint32_t kSeeds = 300;

/// A move of the exhaustive graph.
struct Move {
  AgentId agent;
  Timestep timestep;
  Cell start;
  Cell end;
};

/// reach[a][b]: whether a has to be done before b may start, by the rules as they are defined: all
/// pairs are looked at, then the transitive closure is taken.
class ExhaustiveGraph {
 public:
  explicit ExhaustiveGraph(const Plan& plan) {
    for (std::size_t agent = 0; agent < plan.front().size(); ++agent) {
      for (std::size_t t = 0; t + 1 < plan.size(); ++t) {
        if (plan[t][agent] != plan[t + 1][agent]) {
          moves_.push_back({static_cast<AgentId>(agent), static_cast<Timestep>(t), plan[t][agent],
                            plan[t + 1][agent]});
        }
      }
    }
    const std::size_t count = moves_.size();
    reach_.assign(count, std::vector<bool>(count, false));
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < count; ++b) {
        reach_[a][b] = isBefore(moves_[a], moves_[b]);
      }
    }
    for (std::size_t via = 0; via < count; ++via) {
      for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; reach_[a][via] && b < count; ++b) {
          reach_[a][b] = reach_[a][b] || reach_[via][b];
        }
      }
    }
  }

  const std::vector<Move>& moves() const { return moves_; }
  const std::vector<std::vector<bool>>& reach() const { return reach_; }
  bool hasCycle() const {
    for (std::size_t a = 0; a < moves_.size(); ++a) {
      if (reach_[a][a]) {
        return true;
      }
    }
    return false;
  }

 private:
  static bool isBefore(const Move& a, const Move& b) {
    if (a.agent == b.agent) {
      return a.timestep < b.timestep;
    }
    return a.start == b.end && a.timestep <= b.timestep;
  }

  std::vector<Move> moves_;
  std::vector<std::vector<bool>> reach_;
};

/// The closure of the sparse graph, with tasks in the order of `moves`.
std::vector<std::vector<bool>> closureOf(const ActionDependencyGraph& graph,
                                         const std::vector<Move>& moves) {
  const std::size_t count = moves.size();
  std::vector<std::vector<bool>> before(count, std::vector<bool>(count, false));  // by id
  for (const Task& task : graph.tasks()) {
    auto& ancestors = before[static_cast<std::size_t>(task.id)];
    for (const TaskId dependency : graph.dependencies(task.id)) {
      ancestors[static_cast<std::size_t>(dependency)] = true;
      const auto& further = before[static_cast<std::size_t>(dependency)];
      for (std::size_t id = 0; id < count; ++id) {
        ancestors[id] = ancestors[id] || further[id];
      }
    }
  }
  std::vector<std::size_t> id_of;
  id_of.reserve(moves.size());
  std::vector<std::size_t> next(static_cast<std::size_t>(graph.agentCount()), 0);
  for (const Move& move : moves) {
    id_of.push_back(static_cast<std::size_t>(
        graph.tasksOf(move.agent)[next[static_cast<std::size_t>(move.agent)]++]));
  }
  std::vector<std::vector<bool>> reach(count, std::vector<bool>(count, false));
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      reach[a][b] = before[id_of[b]][id_of[a]];
    }
  }
  return reach;
}

bool holdsAreDisjoint(const ActionDependencyGraph& graph) {
  std::set<Cell> held;
  for (AgentId agent = 0; agent < graph.agentCount(); ++agent) {
    for (const Cell& cell : graph.heldCells(agent)) {
      if (!held.insert(cell).second) {
        return false;
      }
    }
  }
  return true;
}

/// The released tasks that their agents may be at: the first of each.
std::vector<TaskId> inProgress(const ActionDependencyGraph& graph) {
  std::vector<TaskId> tasks;
  for (const TaskId task : graph.releasedTasks()) {
    if (graph.currentTask(graph.task(task).agent) == task) {
      tasks.push_back(task);
    }
  }
  return tasks;
}

/// Carries out up to `count` tasks in some admissible order and checks what must hold after each.
void advance(ActionDependencyGraph& graph, int count, int lookahead, Rng& rng) {
  for (; count > 0 && !graph.isFinished(); --count) {
    graph.release(lookahead);
    const std::vector<TaskId> ready = inProgress(graph);
    ASSERT_FALSE(ready.empty()) << "deadlock";
    for (const TaskId task : graph.releasedTasks()) {
      const std::optional<TaskId>& type2_predecessor = graph.task(task).type2_predecessor;
      ASSERT_TRUE(!type2_predecessor || graph.status(*type2_predecessor) == TaskStatus::Done);
    }
    ASSERT_TRUE(holdsAreDisjoint(graph));
    graph.complete(pickOne(ready, rng));
    ASSERT_TRUE(holdsAreDisjoint(graph));
  }
}

TEST(ActionDependencyGraphProperty, ClosureEqualsTheExhaustiveRules) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Plan plan = randomPlan(rng);
    const ExhaustiveGraph exhaustive(plan);
    const ActionDependencyGraph graph(plan);
    ASSERT_EQ(exhaustive.moves().size(), static_cast<std::size_t>(graph.taskCount()));
    ASSERT_EQ(exhaustive.reach(), closureOf(graph, exhaustive.moves()));
  }
}

TEST(ActionDependencyGraphProperty, IsRefusedIfAndOnlyIfItHasACycleAndThatIsARing) {
  int refused_plans = 0;
  int rotations = 0;
  for (std::uint32_t seed = 0; seed < 10 * kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Plan plan = randomPlan(rng, true);
    Timestep first_ring = -1;
    for (std::size_t t = 0; t + 1 < plan.size() && first_ring < 0; ++t) {
      if (!findRotations(plan[t], plan[t + 1]).empty()) {
        first_ring = static_cast<Timestep>(t);
      }
    }
    const bool has_cycle = ExhaustiveGraph(plan).hasCycle();
    ASSERT_EQ(first_ring >= 0, has_cycle);
    try {
      const ActionDependencyGraph graph(plan);
      ASSERT_FALSE(has_cycle);
    } catch (const PlanRefused& refused) {
      ++refused_plans;
      rotations += refused.agents().size() >= 3 ? 1 : 0;
      ASSERT_EQ(first_ring, refused.timestep()) << refused.what();
    }
  }
  EXPECT_GT(refused_plans, 20);
  EXPECT_EQ(refused_plans, rotations);
  EXPECT_LT(refused_plans, static_cast<int>(10 * kSeeds) - 20);
}

TEST(ActionDependencyGraphProperty, EveryAdmissibleOrderArrivesWithoutCollision) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Plan plan = randomPlan(rng);
    ActionDependencyGraph graph(plan);
    advance(graph, graph.taskCount(), uniform(1, 6, rng), rng);
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_TRUE(graph.isFinished());
    EXPECT_EQ(plan.back(), graph.configuration());
  }
}

/// A task that release() could have given to the agent, and did not.
std::optional<TaskId> forgottenTask(const ActionDependencyGraph& graph, AgentId agent,
                                    int lookahead) {
  const std::vector<TaskId>& tasks = graph.tasksOf(agent);
  const int released = graph.releasedCount(agent);
  if (released == static_cast<int>(tasks.size()) ||
      released - graph.doneCount(agent) >= lookahead) {
    return std::nullopt;
  }
  const TaskId next = tasks[static_cast<std::size_t>(released)];
  const std::optional<TaskId>& predecessor = graph.task(next).type2_predecessor;
  const bool waits = predecessor && graph.status(*predecessor) != TaskStatus::Done;
  return waits ? std::nullopt : std::make_optional(next);
}

TEST(ActionDependencyGraphProperty, ReleaseForgetsNobody) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    ActionDependencyGraph graph(randomPlan(rng));
    while (!graph.isFinished()) {
      const int lookahead = uniform(0, 9, rng) == 0 ? uniform(1, 6, rng) : 2;
      const AgentId except = uniform(0, 2 * graph.agentCount(), rng);
      // Some are released one by one, as from a log.
      for (AgentId agent = 0; agent < graph.agentCount(); ++agent) {
        if (const auto next = forgottenTask(graph, agent, 1); next && uniform(0, 9, rng) == 0) {
          graph.enqueue(*next);
        }
      }
      graph.release(lookahead, {except});
      for (AgentId agent = 0; agent < graph.agentCount(); ++agent) {
        if (agent != except) {
          ASSERT_FALSE(forgottenTask(graph, agent, lookahead)) << "agent " << agent;
        }
      }
      const std::vector<TaskId> ready = inProgress(graph);
      if (!ready.empty()) {
        graph.complete(pickOne(ready, rng));
      }
    }
  }
}

TEST(ActionDependencyGraphProperty, WaitChainsEndWithAnAgentThatCanMove) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    ActionDependencyGraph graph(randomPlan(rng));
    advance(graph, uniform(0, graph.taskCount(), rng), 2, rng);
    graph.release(2);
    for (AgentId agent = 0; agent < graph.agentCount(); ++agent) {
      const std::vector<AgentId> chain = graph.waitChain(agent);
      const std::optional<TaskId> last = graph.currentTask(chain.back());
      ASSERT_TRUE(chain.size() == 1 || last.has_value());
      if (last) {
        EXPECT_EQ(TaskStatus::Enqueued, graph.status(*last));
      }
      if (chain.size() > 1) {
        const std::vector<AgentId> blocked = graph.blockedBy({chain.back()});
        EXPECT_TRUE(std::binary_search(blocked.begin(), blocked.end(), agent));
      }
    }
  }
}

TEST(CommitCutProperty, IsClosedContainsWhatIsReleasedAndLeavesAConsistentState) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    ActionDependencyGraph graph(randomPlan(rng));
    advance(graph, uniform(0, graph.taskCount(), rng), 3, rng);
    const CommitCut cut = graph.commitCut(uniform(0, 3, rng));
    ASSERT_TRUE(graph.isClosed(cut));
    for (AgentId agent = 0; agent < graph.agentCount(); ++agent) {
      EXPECT_GE(cut[static_cast<std::size_t>(agent)], graph.releasedCount(agent));
    }
    const Configuration cells = graph.configurationAt(cut);
    EXPECT_EQ(cells.size(), std::set<Cell>(cells.begin(), cells.end()).size());
  }
}

TEST(ReplaceRestProperty, ANewPlanFromTheCutArrivesWithoutCollision) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Grid grid(uniform(3, 5, rng), uniform(3, 5, rng));
    Configuration cells = grid.freeCells();
    shuffle(cells, rng);
    cells.resize(static_cast<std::size_t>(uniform(1, grid.size() - 1, rng)));
    std::vector<AgentId> agents;
    for (std::size_t agent = 0; agent < cells.size(); ++agent) {
      agents.push_back(static_cast<AgentId>(agent));
    }
    ActionDependencyGraph graph(randomWalk(grid, cells, 15, false, rng));
    Plan rest;
    for (int replacement = 0; replacement < 3; ++replacement) {
      advance(graph, uniform(0, graph.taskCount(), rng), 3, rng);
      const CommitCut cut = graph.commitCut(uniform(0, 2, rng));
      rest = randomWalk(grid, graph.configurationAt(cut), 15, false, rng);
      graph.replaceRest(cut, agents, rest);
      ASSERT_TRUE(holdsAreDisjoint(graph));
    }
    advance(graph, graph.taskCount(), 3, rng);
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(rest.back(), graph.configuration());
  }
}

TEST(ReplaceRestProperty, TheOthersArriveAroundALostRobot) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    Grid grid(uniform(3, 5, rng), uniform(3, 5, rng));
    Configuration cells = grid.freeCells();
    shuffle(cells, rng);
    cells.resize(static_cast<std::size_t>(uniform(2, grid.size() / 2, rng)));
    ActionDependencyGraph graph(randomWalk(grid, cells, 15, false, rng));
    advance(graph, uniform(0, graph.taskCount(), rng), 3, rng);
    // Agent 0 is lost with what it has; everybody else finishes what is released.
    const CommitCut cut = graph.commitCut();
    for (const Cell& cell : graph.heldCells(0)) {
      grid.setObstacle(cell);
    }
    std::vector<AgentId> agents;
    Configuration starts;
    const Configuration at_cut = graph.configurationAt(cut);
    for (AgentId agent = 1; agent < graph.agentCount(); ++agent) {
      agents.push_back(agent);
      starts.push_back(at_cut[static_cast<std::size_t>(agent)]);
    }
    const Plan plan = randomWalk(grid, starts, 15, false, rng);
    const std::vector<Cell> held_by_lost = graph.heldCells(0);
    const int released_to_lost = graph.releasedCount(0);
    graph.replaceRest(cut, agents, plan);
    EXPECT_EQ(held_by_lost, graph.heldCells(0));
    for (;;) {
      graph.release(3);
      EXPECT_EQ(released_to_lost, graph.releasedCount(0));
      ASSERT_TRUE(holdsAreDisjoint(graph));
      std::vector<TaskId> ready = inProgress(graph);
      ready.erase(std::remove_if(ready.begin(), ready.end(),
                                 [&](TaskId task) { return graph.task(task).agent == 0; }),
                  ready.end());
      if (ready.empty()) {
        break;
      }
      graph.complete(pickOne(ready, rng));
    }
    for (std::size_t i = 0; i < agents.size(); ++i) {
      EXPECT_EQ(plan.back()[i], graph.cell(agents[i]));
    }
  }
}

}  // namespace
}  // namespace sylph
