#include "sylph_core/benchmark/run_benchmark.hpp"

#include <memory>

#include "sylph_core/command/parallel_for.hpp"

namespace sylph {
namespace {

BenchmarkRun runCase(const Planner& planner, const BenchmarkCase& benchmark_case,
                     const PlanningLimits& limits) {
  Rng rng(benchmark_case.seed);
  const PlanningResult result = planner.plan(benchmark_case.instance, limits, rng);
  return {planner.name(),
          benchmark_case.family,
          benchmark_case.instance.agentCount(),
          benchmark_case.instance_number,
          result.outcome,
          evaluate(benchmark_case.instance, result),
          result.statistics};
}

}  // namespace

std::vector<BenchmarkRun> runBenchmark(const std::vector<std::string>& planners,
                                       const std::shared_ptr<const Policy>& policy,
                                       const std::vector<BenchmarkCase>& cases,
                                       const PlanningLimits& limits, int jobs,
                                       const BenchmarkProgress& progress) {
  std::vector<std::unique_ptr<Planner>> made;
  made.reserve(planners.size());
  for (const std::string& name : planners) {
    made.push_back(makePlanner(name, policy));
  }
  std::vector<BenchmarkRun> runs(made.size() * cases.size());
  parallelFor(
      runs.size(), jobs,
      [&](std::size_t index) {
        runs[index] = runCase(*made[index / cases.size()], cases[index % cases.size()], limits);
      },
      [&](std::size_t index, std::size_t done) { progress(runs[index], done); });
  return runs;
}

}  // namespace sylph
