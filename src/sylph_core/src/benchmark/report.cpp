#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "sylph_core/benchmark/run_benchmark.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {
namespace {

/// The value below which a share of the sorted values lies, nearest rank.
double percentile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

std::vector<std::string> summarize(const std::vector<const BenchmarkRun*>& runs) {
  std::vector<double> first_s;
  double makespans = 0.0;
  double cost_ratios = 0.0;
  for (const BenchmarkRun* run : runs) {
    if (run->evaluation.is_solved) {
      first_s.push_back(run->statistics.first_solution_s);
      makespans += run->evaluation.metrics.makespan;
      const auto bound = static_cast<double>(run->evaluation.sum_of_costs_lower_bound.value());
      // Who starts on the goals needs no step: as good as the bound.
      cost_ratios +=
          bound > 0.0 ? static_cast<double>(run->evaluation.metrics.sum_of_costs) / bound : 1.0;
    }
  }
  const auto solved = static_cast<double>(first_s.size());
  std::vector<std::string> cells = {
      std::to_string(runs.size()),
      format("%.1f", 100.0 * solved / static_cast<double>(runs.size()))};
  if (first_s.empty()) {
    cells.insert(cells.end(), 4, "-");
    return cells;
  }
  std::sort(first_s.begin(), first_s.end());
  cells.push_back(format("%.3f", percentile(first_s, 0.5)));
  cells.push_back(format("%.3f", percentile(first_s, 0.95)));
  cells.push_back(format("%.3f", cost_ratios / solved));
  cells.push_back(format("%.1f", makespans / solved));
  return cells;
}

/// Columns as wide as their widest cell, the first two to the left, the others to the right.
std::string align(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t col = 0; col < row.size(); ++col) {
      widths[col] = std::max(widths[col], row[col].size());
    }
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t col = 0; col < row.size(); ++col) {
      const std::string padding(widths[col] - row[col].size(), ' ');
      text += (col > 0 ? "  " : "") + (col < 2 ? row[col] + padding : padding + row[col]);
    }
    text += "\n";
  }
  return text;
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
                                                 "first s", "p95 s", "cost / bound", "makespan"}};
  for (const auto& [key, group] : groups) {
    rows.push_back(
        {group.front()->family, group.front()->planner, std::to_string(group.front()->agents)});
    const std::vector<std::string> cells = summarize(group);
    rows.back().insert(rows.back().end(), cells.begin(), cells.end());
  }
  return align(rows);
}

}  // namespace sylph
