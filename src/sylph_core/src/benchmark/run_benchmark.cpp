#include "sylph_core/benchmark/run_benchmark.hpp"

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

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
  for (const std::string& name : planners) {
    made.push_back(makePlanner(name, policy));
  }
  std::vector<BenchmarkRun> runs(made.size() * cases.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // of what follows
  std::size_t done = 0;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t index = next++; index < runs.size(); index = next++) {
      try {
        runs[index] = runCase(*made[index / cases.size()], cases[index % cases.size()], limits);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = std::current_exception();
        next = runs.size();  // the others finish what they are at
        return;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      progress(runs[index], ++done);
    }
  };
  std::vector<std::thread> threads;
  for (int job = 1; job < jobs; ++job) {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads) {
    thread.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  return runs;
}

}  // namespace sylph
