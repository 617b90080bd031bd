// sylph_rehearse: runs an experiment in the simulated lab, in one process and without ROS.

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "rehearsal_report.hpp"
#include "sylph_core/command/progress_bar.hpp"
#include "sylph_core/command/run_command.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_rehearsal/rehearsal.hpp"
#include "sylph_rehearsal/seeds.hpp"

namespace {

using sylph_rehearsal::Ending;
using sylph_rehearsal::Rehearsal;

struct Options {
  std::string experiment_path;
  std::string seeds;
  int robots = 0;
  int jobs = 1;
  bool is_json = false;
};

/// Runs each seed once, in so many threads; no run knows of another one.
std::vector<Rehearsal> runAll(const Options& options, const sylph_rehearsal::SeedRange& seeds) {
  const sylph::Experiment first = sylph::loadExperiment(options.experiment_path);
  const auto policy = sylph::loadPolicyFor(first.planning.planner, first.planning.weights_path);
  std::vector<Rehearsal> runs(seeds.count());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // guards what follows
  std::size_t done = 0;
  sylph::ProgressBar progress(runs.size());
  std::exception_ptr error;
  const auto work = [&] {
    for (std::size_t run = next++; run < runs.size(); run = next++) {
      try {
        const sylph::Experiment experiment = sylph_rehearsal::experimentOf(
            options.experiment_path, seeds.first + static_cast<std::uint32_t>(run), options.robots);
        runs[run] = sylph_rehearsal::rehearse(experiment, {}, policy);
      } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
        next = runs.size();
        return;
      }
      const std::lock_guard lock(mutex);
      if (runs.size() > 1) {
        progress.show(++done);
      }
    }
  };
  std::vector<std::thread> threads;
  for (int job = 1; job < options.jobs; ++job) {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads) {
    thread.join();
  }
  if (error) {
    std::rethrow_exception(error);
  }
  return runs;
}

int rehearseAll(const Options& options) {
  sylph_rehearsal::SeedRange seeds;
  if (options.seeds.empty()) {
    seeds.first = sylph::loadExperiment(options.experiment_path).seed;
    seeds.last = seeds.first;
  } else {
    seeds = sylph_rehearsal::seedsFromText(options.seeds);
  }
  const std::vector<Rehearsal> runs = runAll(options, seeds);
  const sylph::Experiment experiment =
      sylph_rehearsal::experimentOf(options.experiment_path, seeds.first, options.robots);
  std::cout << (options.is_json ? toJson(experiment, runs) + "\n" : toTable(experiment, runs));
  for (const Rehearsal& run : runs) {
    if (run.ending != Ending::Finished) {
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Rehearses an experiment: the whole lab in one process. Exit status: 0 every run finished, "
      "1 one did not, 2 bad input.",
      "sylph_rehearse");
  Options options;
  app.add_option("experiment", options.experiment_path, "experiment file (YAML)")->required();
  app.add_option("--seeds", options.seeds, "A-B or A: one run a seed (default: the experiment's)");
  app.add_option("--robots", options.robots,
                 "so many: the experiment's first ones, or with more at random places added")
      ->check(CLI::Range(1, 100000));
  app.add_option("--jobs", options.jobs, "runs at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_flag("--json", options.is_json, "print one line of JSON");
  return sylph::runCommand(app, argc, argv, [&] { return rehearseAll(options); });
}
