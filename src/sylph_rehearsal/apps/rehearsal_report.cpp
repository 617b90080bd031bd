#include "rehearsal_report.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "run_figures.hpp"

namespace sylph_rehearsal {
namespace {

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

/// Empty without values.
std::string row(const Figure& figure, const std::vector<Rehearsal>& runs) {
  const std::vector<double> values = sortedValues(figure, runs);
  if (values.empty()) {
    return "";
  }
  return format("%-20s %9.2f %9.2f %9.2f %9.2f\n", figure.name, values.front(),
                quantile(values, 0.5), quantile(values, 0.9), values.back());
}

}  // namespace

std::string toTable(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs) {
  constexpr std::size_t kMostLines = 10;
  std::string text = experiment.name + ": " + std::to_string(experiment.robots.size()) +
                     " robots, " + std::to_string(runs.size()) +
                     (runs.size() == 1 ? " run" : " runs") + "\n";
  auto counts = countEndings(runs);
  text += format("finished %d, stopped %d, violated %d\n\n", counts[Ending::Finished],
                 counts[Ending::Stopped], counts[Ending::Violated]);
  text += format("%-20s %9s %9s %9s %9s\n", "", "least", "median", "90 %", "most");
  for (const Figure& figure : runFigures()) {
    text += row(figure, runs);
  }
  for (const Figure& figure : brakingFigures()) {
    text += row(figure, runs);
  }
  const auto longest = longestWaits(experiment, runs);
  if (!longest.empty()) {
    text += "\nwaits, seconds a run\n";
  }
  for (std::size_t i = 0; i < std::min(kMostLines, longest.size()); ++i) {
    text += format("%7.1f  %s\n", longest[i].second, longest[i].first.c_str());
  }
  auto faults = countByFault(runs);
  if (!faults.empty()) {
    text += format("\n%-20s %9s %9s %9s %9s\n", "fault", "runs", "finished", "stopped", "violated");
  }
  for (auto& [kind, endings] : faults) {
    const int finished = endings[Ending::Finished];
    const int stopped = endings[Ending::Stopped];
    const int violated = endings[Ending::Violated];
    text += format("%-20s %9d %9d %9d %9d\n", kind.c_str(), finished + stopped + violated, finished,
                   stopped, violated);
  }
  std::size_t told = 0;
  for (const Rehearsal& run : worstFirst(runs)) {
    if (run.ending == Ending::Finished || ++told > kMostLines) {
      continue;
    }
    text += told == 1 ? "\n" : "";
    text += "seed " + std::to_string(run.seed) + " " + toString(run.ending) +
            format(" after %.1f s: ", run.lab_s) + run.cause + "\n";
  }
  if (told > kMostLines) {
    text += "and " + std::to_string(told - kMostLines) + " more\n";
  }
  return text;
}

std::string toJson(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs) {
  nlohmann::ordered_json line;
  auto counts = countEndings(runs);
  line["experiment"] = experiment.name;
  line["robots"] = experiment.robots.size();
  line["finished"] = counts[Ending::Finished];
  line["stopped"] = counts[Ending::Stopped];
  line["violated"] = counts[Ending::Violated];
  line["runs"] = nlohmann::ordered_json::array();
  for (const Rehearsal& run : runs) {
    nlohmann::ordered_json entry;
    entry["seed"] = run.seed;
    entry["ending"] = toString(run.ending);
    entry["cause"] = run.cause;
    entry["faults"] = nlohmann::ordered_json::array();
    for (const LabFault& fault : run.faults) {
      entry["faults"].push_back(toYaml(fault, experiment));
    }
    entry["arrived"] = run.result.arrived;
    entry["plan_steps"] = run.result.plan_steps;
    entry["sum_of_costs"] = run.result.sum_of_costs;
    entry["execution_s"] = run.result.execution_s;
    entry["ideal_execution_s"] = run.result.ideal_execution_s;
    entry["min_separation_m"] = nullptr;
    if (run.result.min_separation_m) {
      entry["min_separation_m"] = *run.result.min_separation_m;
    }
    entry["max_tracking_error_m"] = run.result.max_tracking_error_m;
    entry["brakings"] = nlohmann::ordered_json::array();
    for (const EmergencyBraking& braking : run.brakings) {
      entry["brakings"].push_back({{"robot", braking.robot},
                                   {"speed_mps", braking.speed_mps},
                                   {"distance_m", braking.distance_m},
                                   {"duration_s", braking.duration_s}});
    }
    entry["replans"] = run.result.replans;
    entry["stops"] = run.result.stops;
    entry["lab_s"] = run.lab_s;
    line["runs"].push_back(std::move(entry));
  }
  return line.dump();
}

}  // namespace sylph_rehearsal
