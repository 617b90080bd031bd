#include <benchmark/benchmark.h>

#include <map>
#include <utility>

#include "../test/adg/random_plan.hpp"
#include "sylph_core/adg/action_dependency_graph.hpp"

namespace sylph {
namespace {

/// A random walk of `agents` robots on a map of which they fill a quarter.
const Plan& planOf(int agents, int steps) {
  static std::map<std::pair<int, int>, Plan> plans;
  Plan& plan = plans[{agents, steps}];
  if (plan.empty()) {
    Rng rng(1);
    int side = 2;
    while (side * side < 4 * agents) {
      ++side;
    }
    const Grid grid(side, side);
    Configuration cells = grid.freeCells();
    shuffle(cells, rng);
    cells.resize(static_cast<std::size_t>(agents));
    plan = test::randomWalk(grid, cells, steps, false, rng);
  }
  return plan;
}

/// range(0) robots, range(1) steps.
void BM_BuildGraph(benchmark::State& state) {
  const Plan& plan = planOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  int tasks = 0;
  for (auto _ : state) {
    const ActionDependencyGraph graph(plan);
    tasks = graph.taskCount();
    benchmark::DoNotOptimize(tasks);
  }
  state.counters["tasks"] = tasks;
}
BENCHMARK(BM_BuildGraph)
    ->Args({8, 100})
    ->Args({100, 500})
    ->Args({1000, 500})
    ->Args({2000, 500})
    ->Unit(benchmark::kMillisecond);

/// Carries a whole plan out, one release and one completed task at a time.
void BM_CarryOut(benchmark::State& state) {
  const Plan& plan = planOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    ActionDependencyGraph graph(plan);
    for (std::vector<TaskId> released = graph.release(); !released.empty();
         released = graph.release()) {
      for (const TaskId task : released) {
        graph.complete(task);
      }
    }
    if (!graph.isFinished()) {
      state.SkipWithError("deadlock");
    }
  }
}
BENCHMARK(BM_CarryOut)->Args({1000, 500})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sylph

BENCHMARK_MAIN();
