#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "benchmark/text_table.hpp"
#include "sylph_core/benchmark/run_benchmark.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

/// The value below which a share of the sorted values lies, nearest rank.
double percentile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

/// Who starts on the goals needs no step: costs of 0 count as 1 on both sides.
double ratio(long cost, long against) {
  return static_cast<double>(std::max(cost, 1L)) / static_cast<double>(std::max(against, 1L));
}

/// Median and 95th percentile, "-" where there is none.
std::vector<std::string> timeCells(std::vector<double> seconds) {
  if (seconds.empty()) {
    return {"-", "-"};
  }
  std::sort(seconds.begin(), seconds.end());
  return {format("%.3f", percentile(seconds, 0.5)), format("%.3f", percentile(seconds, 0.95))};
}

std::vector<std::string> summarize(const std::vector<const BenchmarkRun*>& runs) {
  std::vector<double> first_s;
  std::vector<double> cost_ratios;
  double makespans = 0.0;
  for (const BenchmarkRun* run : runs) {
    if (!run->evaluation.is_solved) {
      continue;
    }
    if (!run->is_external) {
      first_s.push_back(run->statistics.first_solution_s);
    }
    makespans += run->evaluation.metrics.makespan;
    cost_ratios.push_back(ratio(run->evaluation.metrics.sum_of_costs,
                                run->evaluation.sum_of_costs_lower_bound.value()));
  }
  const auto solved = static_cast<double>(cost_ratios.size());
  std::vector<std::string> cells = {
      std::to_string(runs.size()),
      format("%.1f", 100.0 * solved / static_cast<double>(runs.size()))};
  for (const auto& more : {timeCells(first_s), meanCells(cost_ratios)}) {
    cells.insert(cells.end(), more.begin(), more.end());
  }
  cells.push_back(cost_ratios.empty() ? "-" : format("%.1f", makespans / solved));
  return cells;
}

}  // namespace

std::string toCsvLine(const BenchmarkRun& run) {
  const PlanMetrics& metrics = run.evaluation.metrics;
  std::ostringstream out;
  out << run.planner << ',' << run.family << ',' << run.agents << ',' << run.instance_number << ','
      << toString(run.outcome) << ',' << metrics.steps << ',' << metrics.makespan << ','
      << metrics.sum_of_costs << ',';
  if (run.evaluation.sum_of_costs_lower_bound) {
    out << *run.evaluation.sum_of_costs_lower_bound;
  }
  out << ',' << metrics.arrived << ',';
  if (run.evaluation.is_solved && !run.is_external) {
    out << run.statistics.first_solution_s;
  }
  out << ',' << run.statistics.total_s << ',' << run.statistics.policy_calls << '\n';
  return out.str();
}

std::string toCsv(const std::vector<BenchmarkRun>& runs) {
  std::string out =
      "planner,family,agents,instance,outcome,steps,makespan,sum_of_costs,"
      "sum_of_costs_lower_bound,arrived,seconds_to_first,seconds,policy_calls\n";
  for (const BenchmarkRun& run : runs) {
    out += toCsvLine(run);
  }
  return out;
}

std::string toTable(const std::vector<BenchmarkRun>& runs) {
  using Key = std::tuple<std::size_t, std::string, int>;  // order of the families first
  std::map<std::string, std::size_t> family_order;
  std::map<Key, std::vector<const BenchmarkRun*>> groups;
  for (const BenchmarkRun& run : runs) {
    const std::size_t order = family_order.emplace(run.family, family_order.size()).first->second;
    groups[{order, run.planner, run.agents}].push_back(&run);
  }
  std::vector<std::vector<std::string>> rows = {{"family", "planner", "agents", "runs", "solved %",
                                                 "first s", "p95 s", "cost / bound",
                                                 "95 % interval", "makespan"}};
  for (const auto& [key, group] : groups) {
    rows.push_back(
        {group.front()->family, group.front()->planner, std::to_string(group.front()->agents)});
    const std::vector<std::string> cells = summarize(group);
    rows.back().insert(rows.back().end(), cells.begin(), cells.end());
  }
  return alignTable(rows);
}

std::string toRatioTable(const std::vector<BenchmarkRun>& runs) {
  using Case = std::tuple<std::string, int, int>;  // family, agents, instance
  using Group = std::pair<std::string, int>;       // family, agents; empty, 0: all of them
  const auto caseOf = [](const BenchmarkRun& run) {
    return Case(run.family, run.agents, run.instance_number);
  };
  std::map<Case, long> first_costs;
  std::vector<Group> groups;
  std::vector<std::string> others;
  std::map<std::pair<std::string, Group>, std::vector<double>> ratios;
  const auto addOnce = [](auto& values, const auto& value) {
    if (std::find(values.begin(), values.end(), value) == values.end()) {
      values.push_back(value);
    }
  };
  for (const BenchmarkRun& run : runs) {
    const bool is_first = run.planner == runs.front().planner;
    addOnce(groups, Group(run.family, run.agents));
    if (!is_first) {
      addOnce(others, run.planner);
    }
    if (!run.evaluation.is_solved) {
      continue;
    }
    const long cost = run.evaluation.metrics.sum_of_costs;
    if (is_first) {
      first_costs[caseOf(run)] = cost;
    } else if (const auto first = first_costs.find(caseOf(run)); first != first_costs.end()) {
      ratios[{run.planner, {run.family, run.agents}}].push_back(ratio(cost, first->second));
      ratios[{run.planner, {"", 0}}].push_back(ratio(cost, first->second));
    }
  }
  if (others.empty()) {
    return "";
  }
  groups.emplace_back("", 0);
  std::vector<std::vector<std::string>> rows = {{"family", "planner", "agents", "both solve",
                                                 "cost / " + runs.front().planner,
                                                 "95 % interval"}};
  for (const Group& group : groups) {
    for (const std::string& other : others) {
      const std::vector<double>& values = ratios[{other, group}];
      const std::vector<std::string> cells = meanCells(values);
      rows.push_back({group.second == 0 ? "all" : group.first, other,
                      group.second == 0 ? "" : std::to_string(group.second),
                      std::to_string(values.size()), cells[0], cells[1]});
    }
  }
  return alignTable(rows);
}

}  // namespace sylph
