#include "run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace sylph_rehearsal {
namespace {

using Values = std::vector<double>;

Values ofFinished(const Rehearsal& run, double value) {
  return run.ending == Ending::Finished ? Values{value} : Values{};
}

Figure brakingFigure(const char* name, double EmergencyBraking::*member, double factor) {
  return {name, [member, factor](const Rehearsal& run) {
            Values values;
            for (const EmergencyBraking& braking : run.brakings) {
              values.push_back(factor * braking.*member);
            }
            return values;
          }};
}

}  // namespace

std::vector<Figure> runFigures() {
  const auto ratio = [](const Rehearsal& run) {
    const double ideal_s = run.result.ideal_execution_s;
    return ideal_s > 0.0 ? ofFinished(run, run.result.execution_s / ideal_s) : Values{};
  };
  const auto gap_mm = [](const Rehearsal& run) {
    return run.result.min_separation_m ? Values{*run.result.min_separation_m * 1e3} : Values{};
  };
  return {
      {"execution [s]",
       [](const Rehearsal& run) { return ofFinished(run, run.result.execution_s); }},
      {"execution / ideal", ratio},
      {"plan [steps]", [](const Rehearsal& run) { return Values{double(run.result.plan_steps)}; }},
      {"closest [mm]", gap_mm},
      {"tracking error [mm]",
       [](const Rehearsal& run) { return Values{run.result.max_tracking_error_m * 1e3}; }}};
}

std::vector<Figure> brakingFigures() {
  return {brakingFigure("braking [mm]", &EmergencyBraking::distance_m, 1e3),
          brakingFigure("braking [s]", &EmergencyBraking::duration_s, 1.0)};
}

std::vector<double> sortedValues(const Figure& figure, const std::vector<Rehearsal>& runs) {
  Values all;
  for (const Rehearsal& run : runs) {
    const Values values = figure.of(run);
    all.insert(all.end(), values.begin(), values.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

double quantile(const std::vector<double>& sorted, double share) {
  const auto rank =
      static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)));
  return sorted[rank];
}

EndingCounts countEndings(const std::vector<Rehearsal>& runs) {
  EndingCounts counts;
  for (const Rehearsal& run : runs) {
    ++counts[run.ending];
  }
  return counts;
}

std::map<std::string, EndingCounts> countByFault(const std::vector<Rehearsal>& runs) {
  std::map<std::string, EndingCounts> rows;
  for (const Rehearsal& run : runs) {
    std::set<std::string> kinds;
    for (const LabFault& fault : run.faults) {
      kinds.insert(toName(fault));
    }
    for (const std::string& kind : kinds) {
      ++rows[kind][run.ending];
    }
  }
  return rows;
}

std::vector<std::reference_wrapper<const Rehearsal>> worstFirst(
    const std::vector<Rehearsal>& runs) {
  std::vector<std::reference_wrapper<const Rehearsal>> sorted(runs.begin(), runs.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Rehearsal& a, const Rehearsal& b) { return a.ending > b.ending; });
  return sorted;
}

std::vector<std::pair<std::string, double>> longestWaits(const sylph::Experiment& experiment,
                                                         const std::vector<Rehearsal>& runs) {
  std::map<std::pair<int, int>, double> sums;
  for (const Rehearsal& run : runs) {
    for (const WaitingTime& wait : run.waits) {
      sums[{wait.robot, wait.blocker}] += wait.duration_s;
    }
  }
  std::vector<std::pair<std::string, double>> sorted;
  sorted.reserve(sums.size());
  const auto name = [&](int robot) { return experiment.robots[std::size_t(robot)].name; };
  for (const auto& [pair, sum_s] : sums) {
    sorted.emplace_back(name(pair.first) + " for " + name(pair.second),
                        sum_s / static_cast<double>(runs.size()));
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return sorted;
}

}  // namespace sylph_rehearsal
