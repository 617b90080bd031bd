#include "rehearsal_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace sylph_rehearsal {
namespace {

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

/// The value below which a share of all lies, by the nearest rank.
double quantile(const std::vector<double>& sorted, double share) {
  const auto rank =
      static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)));
  return sorted[rank];
}

struct Figure {
  const char* name;
  std::function<std::optional<double>(const Rehearsal&)> of;
};

std::vector<Figure> figures() {
  const auto ratio = [](const Rehearsal& run) -> std::optional<double> {
    if (run.ending != Ending::Finished || run.result.ideal_execution_s <= 0.0) {
      return std::nullopt;
    }
    return run.result.execution_s / run.result.ideal_execution_s;
  };
  const auto gap_mm = [](const Rehearsal& run) -> std::optional<double> {
    return run.result.min_separation_m ? std::make_optional(*run.result.min_separation_m * 1e3)
                                       : std::nullopt;
  };
  const auto finished_s = [](const Rehearsal& run) {
    return run.ending == Ending::Finished ? std::make_optional(run.result.execution_s)
                                          : std::nullopt;
  };
  return {{"execution [s]", finished_s},
          {"execution / ideal", ratio},
          {"plan [steps]", [](const Rehearsal& run) { return double(run.result.plan_steps); }},
          {"closest [mm]", gap_mm},
          {"tracking error [mm]",
           [](const Rehearsal& run) { return run.result.max_tracking_error_m * 1e3; }}};
}

/// Empty without values.
std::string row(const char* name, std::vector<double> values) {
  if (values.empty()) {
    return "";
  }
  std::sort(values.begin(), values.end());
  return format("%-20s %9.2f %9.2f %9.2f %9.2f\n", name, values.front(), quantile(values, 0.5),
                quantile(values, 0.9), values.back());
}

/// Of the robots that an emergency stop found driving: how far and how long they drove on.
std::string brakingRows(const std::vector<Rehearsal>& runs) {
  std::vector<double> distances_mm;
  std::vector<double> durations_s;
  for (const Rehearsal& run : runs) {
    for (const EmergencyBraking& braking : run.brakings) {
      distances_mm.push_back(braking.distance_m * 1e3);
      durations_s.push_back(braking.duration_s);
    }
  }
  return row("braking [mm]", distances_mm) + row("braking [s]", durations_s);
}

std::map<Ending, int> countEndings(const std::vector<Rehearsal>& runs) {
  std::map<Ending, int> counts;
  for (const Rehearsal& run : runs) {
    ++counts[run.ending];
  }
  return counts;
}

std::vector<std::reference_wrapper<const Rehearsal>> worstFirst(
    const std::vector<Rehearsal>& runs) {
  std::vector<std::reference_wrapper<const Rehearsal>> sorted(runs.begin(), runs.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Rehearsal& a, const Rehearsal& b) { return a.ending > b.ending; });
  return sorted;
}

struct FaultRow {
  int runs = 0;
  std::map<Ending, int> endings;
};

/// How runs ended, by each kind of fault that they had.
std::map<std::string, FaultRow> byFault(const std::vector<Rehearsal>& runs) {
  std::map<std::string, FaultRow> rows;
  for (const Rehearsal& run : runs) {
    std::set<std::string> kinds;
    for (const LabFault& fault : run.faults) {
      kinds.insert(toName(fault));
    }
    for (const std::string& kind : kinds) {
      ++rows[kind].runs;
      ++rows[kind].endings[run.ending];
    }
  }
  return rows;
}

/// Seconds a run, by pair of robots, the longest first.
std::vector<std::pair<double, std::string>> waits(const sylph::Experiment& experiment,
                                                  const std::vector<Rehearsal>& runs) {
  std::map<std::pair<int, int>, double> sums;
  for (const Rehearsal& run : runs) {
    for (const WaitingTime& wait : run.waits) {
      sums[{wait.robot, wait.blocker}] += wait.duration_s;
    }
  }
  std::vector<std::pair<double, std::string>> sorted;
  sorted.reserve(sums.size());
  const auto name = [&](int robot) { return experiment.robots[std::size_t(robot)].name; };
  for (const auto& [pair, sum_s] : sums) {
    sorted.emplace_back(sum_s / static_cast<double>(runs.size()),
                        name(pair.first) + " for " + name(pair.second));
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  return sorted;
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
  for (const Figure& figure : figures()) {
    std::vector<double> values;
    for (const Rehearsal& run : runs) {
      if (const auto value = figure.of(run)) {
        values.push_back(*value);
      }
    }
    text += row(figure.name, values);
  }
  text += brakingRows(runs);
  const auto longest = waits(experiment, runs);
  if (!longest.empty()) {
    text += "\nwaits, seconds a run\n";
  }
  for (std::size_t i = 0; i < std::min(kMostLines, longest.size()); ++i) {
    text += format("%7.1f  %s\n", longest[i].first, longest[i].second.c_str());
  }
  auto faults = byFault(runs);
  if (!faults.empty()) {
    text += format("\n%-20s %9s %9s %9s %9s\n", "fault", "runs", "finished", "stopped", "violated");
  }
  for (auto& [kind, fault] : faults) {
    text +=
        format("%-20s %9d %9d %9d %9d\n", kind.c_str(), fault.runs, fault.endings[Ending::Finished],
               fault.endings[Ending::Stopped], fault.endings[Ending::Violated]);
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
