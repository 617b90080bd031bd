#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sylph_core/benchmark/evaluation.hpp"
#include "sylph_core/benchmark/run_outcome.hpp"
#include "sylph_core/benchmark/suite.hpp"
#include "sylph_core/policy/policy.hpp"

namespace sylph {

/// One planner or solver on one case.
struct BenchmarkRun {
  std::string planner;                         ///< its name
  std::string family;                          ///< name
  int agents = 0;                              ///< of the instance
  int instance_number = 0;                     ///< within the family, from 0
  RunOutcome outcome = RunOutcome::TimeLimit;  ///< Solved, Invalid: by checkPlan()
  Evaluation evaluation;                       ///< as it was found to be
  PlanningStatistics statistics;               ///< what it took
  bool is_external = false;  ///< by a solver: nobody knows when it had its first solution
  std::string message;       ///< one line on what went wrong, else empty
};

/// Told of a run that is over, and of how many are.
using BenchmarkProgress = std::function<void(const BenchmarkRun&, std::size_t)>;

/// Runs every planner, its ablations and external solvers of a suite on every case, by turns: all
/// of them on one case before the next one, so that a computer that grows slower does so for all of
/// them.
///
/// With external solvers each run keeps to one CPU, planners and solvers alike, however many
/// threads they have: the first that the calling thread may use (taskset(1) sets which these are),
/// with more jobs the next ones too.
/// @param cases     as makeCases() gives them
/// @param policy    for the planners that need one, nullptr if none does
/// @param jobs      runs at a time, > 0; more of them than free cores blur the times
/// @param progress  told after each run what came of it and how many are done, never by two threads
///                  at once
/// @return          the runs, planners in order, then solvers in order; of each its cases in order
/// @throws std::invalid_argument as makePlanner()
/// @throws std::runtime_error as solve()
std::vector<BenchmarkRun> runBenchmark(const BenchmarkSuite& suite,
                                       const std::vector<BenchmarkCase>& cases,
                                       const std::shared_ptr<const Policy>& policy, int jobs,
                                       const BenchmarkProgress& progress);

/// One line, with its end.
std::string toCsvLine(const BenchmarkRun& run);

/// One line a run, with a header line.
std::string toCsv(const std::vector<BenchmarkRun>& runs);

/// One line for each planner, family and number of agents. Times and costs are over the solved
/// runs: median and 95th percentile of the time to the first solution [s], which of an external
/// solver nobody knows; mean of the sum of costs over its lower bound and the interval that
/// bootstrapMean() gives it; mean makespan [timesteps].
std::string toTable(const std::vector<BenchmarkRun>& runs);

/// Each planner against the first one of the runs, over the cases that both solve: mean of the
/// ratio of their sums of costs, with its interval. One line for each family, number of agents and
/// planner, then one for each planner over all of them. Empty if there is no second planner.
/// @param runs  as runBenchmark() gives them
std::string toRatioTable(const std::vector<BenchmarkRun>& runs);

}  // namespace sylph
