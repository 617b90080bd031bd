// sylph_rehearse: runs an experiment in the simulated lab, in one process and without ROS.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "rehearsal_page.hpp"
#include "rehearsal_report.hpp"
#include "sylph_core/command/parallel_for.hpp"
#include "sylph_core/command/progress_bar.hpp"
#include "sylph_core/command/run_command.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/files/write_file.hpp"
#include "sylph_core/planners/planner.hpp"
#include "sylph_core/policy/policy.hpp"
#include "sylph_rehearsal/rehearsal.hpp"
#include "sylph_rehearsal/seeds.hpp"
#include "sylph_rehearsal/shrink.hpp"

namespace {

using sylph_rehearsal::Ending;
using sylph_rehearsal::Rehearsal;

struct Options {
  std::string experiment_path;
  std::string seeds;
  int robots = 0;
  int jobs = 1;
  std::string faults_path;
  bool has_random_faults = false;
  bool is_json = false;
  std::string event_logs;
  std::string report_path;
};

/// So many are shrunk, as each takes many runs.
constexpr int kMostFailures = 3;

/// Draws of a run's faults have nothing to do with its other draws.
constexpr std::uint32_t kFaultsPart = 4000;

std::vector<sylph_rehearsal::LabFault> faultsOf(const Options& options,
                                                const sylph::Experiment& experiment) {
  if (options.has_random_faults) {
    std::seed_seq sequence{experiment.seed, kFaultsPart};
    sylph::Rng rng(sequence);
    return sylph_rehearsal::randomFaults(experiment, rng);
  }
  return options.faults_path.empty() ? std::vector<sylph_rehearsal::LabFault>{}
                                     : sylph_rehearsal::loadFaults(options.faults_path, experiment);
}

/// Runs each seed once, in so many threads; no run knows of another one.
std::vector<Rehearsal> runAll(const Options& options, const sylph_rehearsal::SeedRange& seeds,
                              const std::shared_ptr<const sylph::Policy>& policy) {
  std::vector<Rehearsal> runs(seeds.count());
  sylph::ProgressBar progress(runs.size());
  sylph::parallelFor(
      runs.size(), options.jobs,
      [&](std::size_t run) {
        const sylph::Experiment experiment = sylph_rehearsal::experimentOf(
            options.experiment_path, seeds.first + static_cast<std::uint32_t>(run), options.robots);
        runs[run] =
            sylph_rehearsal::rehearse(experiment, {}, policy, faultsOf(options, experiment));
      },
      [&](std::size_t, std::size_t done) {
        if (runs.size() > 1) {
          progress.show(done);
        }
      });
  return runs;
}

/// Writes what the central node logged in each run, as it does in the lab: FOLDER/<seed>.jsonl.
void writeEventLogs(const std::string& folder, const std::vector<Rehearsal>& runs) {
  std::filesystem::create_directories(folder);
  for (const Rehearsal& run : runs) {
    std::string lines;
    for (const std::string& line : run.event_log) {
      lines += line + "\n";
    }
    sylph::writeFile(folder + "/" + std::to_string(run.seed) + ".jsonl", lines);
  }
}

/// How to see a run again, and what is the least that makes it fail.
void tellFailure(const Options& options, const std::shared_ptr<const sylph::Policy>& policy,
                 const Rehearsal& run) {
  const sylph::Experiment experiment =
      sylph_rehearsal::experimentOf(options.experiment_path, run.seed, options.robots);
  const std::vector<sylph_rehearsal::LabFault> least =
      sylph_rehearsal::shrink(run.faults, [&](const auto& faults) {
        return sylph_rehearsal::rehearse(experiment, {}, policy, faults).ending == Ending::Violated;
      });
  std::cerr << "again: sylph_rehearse " << options.experiment_path << " --seeds " << run.seed
            << (options.robots > 0 ? " --robots " + std::to_string(options.robots) : "")
            << (options.has_random_faults ? " --random-faults" : "")
            << (options.faults_path.empty() ? "" : " --faults " + options.faults_path)
            << "\nleast that fails, for --faults:\nfaults:" << (least.empty() ? " []" : "") << "\n";
  for (const sylph_rehearsal::LabFault& fault : least) {
    std::cerr << "  - " << toYaml(fault, experiment) << "\n";
  }
}

int rehearseAll(const Options& options) {
  const sylph::Experiment file = sylph::loadExperiment(options.experiment_path);
  const auto policy = sylph::loadPolicyFor(file.planning.planner, file.planning.weights_path);
  sylph_rehearsal::SeedRange seeds;
  if (options.seeds.empty()) {
    seeds.first = file.seed;
    seeds.last = seeds.first;
  } else {
    seeds = sylph_rehearsal::seedsFromText(options.seeds);
  }
  if (!options.report_path.empty()) {
    sylph::writeFile(options.report_path, "");  // a wrong path is told before hours of runs
  }
  const std::vector<Rehearsal> runs = runAll(options, seeds, policy);
  if (!options.event_logs.empty()) {
    writeEventLogs(options.event_logs, runs);
  }
  const sylph::Experiment experiment =
      sylph_rehearsal::experimentOf(options.experiment_path, seeds.first, options.robots);
  if (!options.report_path.empty()) {
    sylph::writeFile(options.report_path, toPage(experiment, runs));
  }
  std::cout << (options.is_json ? toJson(experiment, runs) + "\n" : toTable(experiment, runs));
  const bool has_faults = options.has_random_faults || !options.faults_path.empty();
  bool is_good = true;
  int told = 0;
  for (const Rehearsal& run : runs) {
    is_good = is_good &&
              (run.ending == Ending::Finished || (has_faults && run.ending == Ending::Stopped));
    if (run.ending == Ending::Violated && told++ < kMostFailures) {
      tellFailure(options, policy, run);
    }
  }
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Rehearses an experiment: the whole lab in one process. Exit status: 0 every run finished "
      "or, "
      "with faults, stopped with a cause; 1 one did not; 2 bad input.",
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
  auto* const faults = app.add_option("--faults", options.faults_path, "what goes wrong (YAML)");
  app.add_flag("--random-faults", options.has_random_faults, "drawn from the seed, some at once")
      ->excludes(faults);
  app.add_option("--event-logs", options.event_logs,
                 "folder for the central node's event log of each run, <seed>.jsonl");
  app.add_option("--report", options.report_path, "HTML page to write: the table with figures");
  app.add_flag("--json", options.is_json, "print one line of JSON");
  return sylph::runCommand(app, argc, argv, [&] { return rehearseAll(options); });
}
