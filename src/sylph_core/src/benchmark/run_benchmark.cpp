#include "sylph_core/benchmark/run_benchmark.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "benchmark/cpu_pinning.hpp"
#include "sylph_core/command/parallel_for.hpp"

namespace sylph {
namespace {

using RunCase = std::function<BenchmarkRun(const BenchmarkCase&)>;

BenchmarkRun toRun(const std::string& planner, const BenchmarkCase& benchmark_case,
                   const PlanningResult& result) {
  BenchmarkRun run;
  run.planner = planner;
  run.family = benchmark_case.family;
  run.agents = benchmark_case.instance.agentCount();
  run.instance_number = benchmark_case.instance_number;
  run.outcome = toRunOutcome(result.outcome);
  run.evaluation = evaluate(benchmark_case.instance, result);
  if (run.evaluation.violation) {
    run.outcome = RunOutcome::Invalid;
    run.message = run.evaluation.violation->message;
  }
  run.statistics = result.statistics;
  return run;
}

BenchmarkRun runPlanner(const Planner& planner, const BenchmarkCase& benchmark_case,
                        const PlanningLimits& limits) {
  Rng rng(benchmark_case.seed);
  return toRun(planner.name(), benchmark_case, planner.plan(benchmark_case.instance, limits, rng));
}

BenchmarkRun runSolver(const ExternalSolver& solver, const BenchmarkCase& benchmark_case,
                       const PlanningLimits& limits) {
  SolverAnswer answer =
      solve(solver, benchmark_case.instance, benchmark_case.seed, limits.time_limit_s);
  const bool is_too_long = answer.plan.size() > static_cast<std::size_t>(limits.max_steps) + 1;
  PlanningResult result;
  result.outcome =
      answer.outcome == RunOutcome::Solved && !is_too_long ? Outcome::Solved : Outcome::TimeLimit;
  result.plan = is_too_long ? Plan() : std::move(answer.plan);
  result.statistics.total_s = answer.seconds;
  result.statistics.sum_of_costs_lower_bound = sumOfCostsLowerBound(benchmark_case.instance);
  BenchmarkRun run = toRun(solver.name, benchmark_case, result);
  run.is_external = true;
  if (result.outcome != Outcome::Solved) {
    run.outcome = is_too_long ? RunOutcome::StepLimit : answer.outcome;
    run.message = answer.message;
  }
  return run;
}

}  // namespace

std::vector<BenchmarkRun> runBenchmark(const BenchmarkSuite& suite,
                                       const std::vector<BenchmarkCase>& cases,
                                       const std::shared_ptr<const Policy>& policy, int jobs,
                                       const BenchmarkProgress& progress) {
  std::vector<RunCase> entrants;
  const auto enter = [&](const std::shared_ptr<const Planner>& planner) {
    entrants.emplace_back([planner, &suite](const BenchmarkCase& benchmark_case) {
      return runPlanner(*planner, benchmark_case, suite.limits);
    });
  };
  for (const std::string& name : suite.planners) {
    enter(makePlanner(name, policy));
    if (needsPolicy(name)) {
      for (const std::string& ablation : suite.ablations) {
        enter(makePlanner(name, policy, ablation));
      }
    }
  }
  for (const ExternalSolver& solver : suite.external) {
    entrants.emplace_back([&](const BenchmarkCase& benchmark_case) {
      return runSolver(solver, benchmark_case, suite.limits);
    });
  }
  CpuPool cpus;
  std::vector<BenchmarkRun> runs(entrants.size() * cases.size());
  const auto placeOf = [&](std::size_t index) {
    return index % entrants.size() * cases.size() + index / entrants.size();
  };
  parallelFor(
      runs.size(), jobs,
      [&](std::size_t index) {
        std::optional<PinnedToCpu> pinned;
        if (!suite.external.empty()) {
          pinned.emplace(cpus);
        }
        runs[placeOf(index)] = entrants[index % entrants.size()](cases[index / entrants.size()]);
      },
      [&](std::size_t index, std::size_t done) { progress(runs[placeOf(index)], done); });
  return runs;
}

}  // namespace sylph
