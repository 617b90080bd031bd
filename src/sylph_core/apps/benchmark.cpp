// sylph_benchmark: runs planners and external solvers on a suite of instances.

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <ios>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "sylph_core/benchmark/run_benchmark.hpp"
#include "sylph_core/benchmark/suite.hpp"
#include "sylph_core/command/progress_bar.hpp"
#include "sylph_core/command/run_command.hpp"
#include "sylph_core/files/write_file.hpp"
#include "weights_option.hpp"

namespace {

struct Options {
  std::string suite_path;
  std::vector<std::string> planners;
  std::string weights_path;
  int jobs = 1;
  std::string csv_path;
};

/// Tells on standard error what went wrong.
/// @return status 1 if a planner or solver called something a solution that is none, or failed
int report(const std::vector<sylph::BenchmarkRun>& runs) {
  int status = EXIT_SUCCESS;
  for (const sylph::BenchmarkRun& run : runs) {
    if (!run.message.empty()) {
      std::cerr << "sylph_benchmark: " << run.planner << " on " << run.family << ", instance "
                << run.instance_number << ", " << run.agents << " agents: " << run.message << "\n";
    }
    if (run.outcome == sylph::RunOutcome::Invalid || run.outcome == sylph::RunOutcome::Failed) {
      status = EXIT_FAILURE;
    }
  }
  return status;
}

/// @return status as of report()
int benchmark(const Options& options) {
  sylph::BenchmarkSuite suite = sylph::loadSuite(options.suite_path);
  if (!options.planners.empty()) {
    suite.planners = options.planners;
  }
  suite.limits.social_states = false;  // nothing here shows them
  for (const sylph::ExternalSolver& solver : suite.external) {
    sylph::findProgram(solver);  // a missing one shows before hours of work, not after
  }
  const std::vector<sylph::BenchmarkCase> cases = sylph::makeCases(suite);
  const auto policy = sylph::loadPolicy(suite.planners, options.weights_path);
  const auto writeCsv = [&](const std::string& text, std::ios::openmode mode) {
    if (!options.csv_path.empty()) {
      sylph::writeFile(options.csv_path, text, mode);
    }
  };
  writeCsv(sylph::toCsv({}), std::ios::trunc);  // likewise
  sylph::ProgressBar bar(sylph::entrantCount(suite) * cases.size());
  const auto runs = sylph::runBenchmark(suite, cases, policy, options.jobs,
                                        [&](const sylph::BenchmarkRun& run, std::size_t done) {
                                          writeCsv(sylph::toCsvLine(run), std::ios::app);
                                          bar.show(done);
                                        });
  std::cout << sylph::toTable(runs);
  if (const std::string ratios = sylph::toRatioTable(runs); !ratios.empty()) {
    std::cout << "\n" << ratios;
  }
  writeCsv(sylph::toCsv(runs), std::ios::trunc);  // in order, whatever the order of the ends
  return report(runs);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Runs planners and external solvers on a suite of instances and prints tables. Exit status: "
      "0 done, 1 one of them called something a solution that is none, or a solver failed, 2 bad "
      "input.",
      "sylph_benchmark");
  Options options;
  app.add_option("SUITE", options.suite_path, "YAML file, see loadSuite()")->required();
  app.add_option("--planner", options.planners,
                 "in place of the suite's planners; its external solvers run too")
      ->check(CLI::IsMember(sylph::plannerNames()))
      ->take_all();
  sylph::addWeightsOption(app, options.weights_path);
  app.add_option("--jobs", options.jobs, "runs at a time; more than free cores blur the times")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()))
      ->capture_default_str();
  app.add_option("--out", options.csv_path, "CSV file to write, one line a run, as they end");
  return sylph::runCommand(app, argc, argv, [&] { return benchmark(options); });
}
