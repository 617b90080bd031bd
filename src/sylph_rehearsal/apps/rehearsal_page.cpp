#include "rehearsal_page.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "histogram.hpp"
#include "run_figures.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph_rehearsal {
namespace {

using sylph::format;

// The look of the report of a run.
constexpr const char* kStyle = R"(
body { font-family: "Liberation Sans", Arial, sans-serif; max-width: 66rem; margin: 2rem auto; color: #222; }
svg { max-width: 100%; height: auto; display: block; }
table { border-collapse: collapse; }
td, th { text-align: left; padding: 0.15rem 1.5rem 0.15rem 0; border-bottom: 1px solid #ddd; vertical-align: top; }
td.number, th.number { text-align: right; }
)";
constexpr std::size_t kMostCauses = 30;
constexpr std::size_t kMostSeeds = 5;
constexpr std::size_t kMostWaits = 15;

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string cell(const std::string& text) {
  return "<td>" + escaped(text) + "</td>";
}

std::string numberCell(const std::string& number) {
  return "<td class=\"number\">" + number + "</td>";
}

std::string numberCell(int number) {
  return numberCell(std::to_string(number));
}

/// @param words    names of the first columns
/// @param numbers  names of those that follow
std::string table(const std::vector<std::string>& words, const std::vector<std::string>& numbers,
                  const std::string& rows) {
  std::string head;
  for (const std::string& name : words) {
    head += "<th>" + name + "</th>";
  }
  for (const std::string& name : numbers) {
    head += "<th class=\"number\">" + name + "</th>";
  }
  return "<table>\n<tr>" + head + "</tr>\n" + rows + "</table>\n";
}

/// With N for each number, so that causes which tell of different robots and times are one.
std::string withoutNumbers(const std::string& text) {
  std::string kind;
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_point = text[i] == '.' && i > 0 && i + 1 < text.size() && isDigit(text[i - 1]) &&
                          isDigit(text[i + 1]);
    if (!isDigit(text[i]) && !is_point) {
      kind += text[i];
    } else if (kind.empty() || kind.back() != 'N') {
      kind += 'N';
    }
  }
  return kind;
}

std::string endingTable(const std::vector<Rehearsal>& runs) {
  EndingCounts counts = countEndings(runs);
  std::string rows;
  for (const Ending ending : {Ending::Finished, Ending::Stopped, Ending::Violated}) {
    const double share = counts[ending] / static_cast<double>(runs.size());
    rows += "<tr>" + cell(toString(ending)) + numberCell(counts[ending]) +
            numberCell(format("%.1f", 100.0 * share)) + "</tr>\n";
  }
  return table({"ending"}, {"runs", "%"}, rows);
}

std::string causeTable(const std::vector<Rehearsal>& runs) {
  std::map<std::pair<Ending, std::string>, std::vector<std::uint32_t>> seeds;
  for (const Rehearsal& run : runs) {
    if (run.ending != Ending::Finished) {
      seeds[{run.ending, withoutNumbers(run.cause)}].push_back(run.seed);
    }
  }
  if (seeds.empty()) {
    return "";
  }
  std::vector<std::pair<std::pair<Ending, std::string>, std::vector<std::uint32_t>>> sorted(
      seeds.begin(), seeds.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.first.first != b.first.first ? a.first.first > b.first.first
                                          : a.second.size() > b.second.size();
  });
  std::string rows;
  for (std::size_t i = 0; i < std::min(kMostCauses, sorted.size()); ++i) {
    const auto& [cause, causes_seeds] = sorted[i];
    std::string first_seeds;
    for (std::size_t k = 0; k < std::min(kMostSeeds, causes_seeds.size()); ++k) {
      first_seeds += (k > 0 ? ", " : "") + std::to_string(causes_seeds[k]);
    }
    first_seeds += causes_seeds.size() > kMostSeeds ? ", ..." : "";
    rows += "<tr>" + cell(toString(cause.first)) + cell(cause.second) + cell(first_seeds) +
            numberCell(static_cast<int>(causes_seeds.size())) + "</tr>\n";
  }
  const std::string more =
      sorted.size() > kMostCauses
          ? "<p>and " + std::to_string(sorted.size() - kMostCauses) + " other causes</p>\n"
          : "";
  return "<h2>Why runs did not finish</h2>\n<p>N is any number, as of a robot or of "
         "seconds.</p>\n" +
         table({"ending", "cause", "seeds"}, {"runs"}, rows) + more;
}

std::string figureTable(const std::vector<Figure>& figures, const std::vector<Rehearsal>& runs) {
  std::string rows;
  for (const Figure& figure : figures) {
    const std::vector<double> values = sortedValues(figure, runs);
    if (!values.empty()) {
      rows += "<tr>" + cell(figure.name);
      for (const double share : {0.0, 0.5, 0.9, 0.99, 1.0}) {
        rows += numberCell(format("%.2f", quantile(values, share)));
      }
      rows += numberCell(static_cast<int>(values.size())) + "</tr>\n";
    }
  }
  return rows.empty() ? ""
                      : table({""}, {"least", "median", "90 %", "99 %", "most", "values"}, rows);
}

/// Empty if no run has the figure.
std::string histogram(const std::vector<Figure>& figures, const std::string& name,
                      const std::vector<Rehearsal>& runs, const std::string& title,
                      const std::string& counted,
                      const std::optional<HistogramMark>& mark = std::nullopt) {
  for (const Figure& figure : figures) {
    const std::vector<double> values = sortedValues(figure, runs);
    if (figure.name == name && !values.empty()) {
      return "<h2>" + title + "</h2>\n" + histogramSvg(values, name, counted, mark);
    }
  }
  return "";
}

std::string faultTable(const std::vector<Rehearsal>& runs) {
  std::string rows;
  for (auto& [kind, counts] : countByFault(runs)) {
    EndingCounts endings = counts;
    rows += "<tr>" + cell(kind) +
            numberCell(endings[Ending::Finished] + endings[Ending::Stopped] +
                       endings[Ending::Violated]) +
            numberCell(endings[Ending::Finished]) + numberCell(endings[Ending::Stopped]) +
            numberCell(endings[Ending::Violated]) + "</tr>\n";
  }
  return rows.empty()
             ? ""
             : "<h2>Faults</h2>\n<p>A run counts in the row of each kind that it had.</p>\n" +
                   table({"fault"}, {"runs", "finished", "stopped", "violated"}, rows);
}

std::string waitTable(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs) {
  const auto waits = longestWaits(experiment, runs);
  std::string rows;
  for (std::size_t i = 0; i < std::min(kMostWaits, waits.size()); ++i) {
    rows += "<tr>" + cell(waits[i].first) + numberCell(format("%.1f", waits[i].second)) + "</tr>\n";
  }
  return rows.empty() ? "" : "<h2>Who waited for whom</h2>\n" + table({""}, {"[s] a run"}, rows);
}

std::string brakingPart(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs) {
  const double reckoned_mm = 1e3 * sylph::stoppingDistance(sylph::separationLimits(experiment),
                                                           experiment.execution.speed_limit_mps);
  const std::string drawn =
      histogram(brakingFigures(), "braking [mm]", runs, "Emergency stops", "robots",
                HistogramMark{reckoned_mm, "reckoned at the speed limit"});
  return drawn.empty()
             ? ""
             : drawn +
                   "<p>How far each robot that was driving went on, by the truth, and what "
                   "the separation monitor reckons with at the speed limit.</p>\n" +
                   figureTable(brakingFigures(), runs);
}

}  // namespace

std::string toPage(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs) {
  const double limit_mm = 1e3 * sylph::separationLimits(experiment).limit_m;
  const auto [first, last] =
      std::minmax_element(runs.begin(), runs.end(),
                          [](const Rehearsal& a, const Rehearsal& b) { return a.seed < b.seed; });
  const std::string seeds = first->seed == last->seed ? "seed " + std::to_string(first->seed)
                                                      : "seeds " + std::to_string(first->seed) +
                                                            " to " + std::to_string(last->seed);
  const std::string name = escaped(experiment.name);
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + name +
         ", rehearsed</title><style>" + kStyle + "</style></head><body>\n<h1>" + name +
         ", rehearsed</h1>\n<p>" + std::to_string(experiment.robots.size()) + " robots, " +
         std::to_string(runs.size()) + (runs.size() == 1 ? " run, " : " runs, ") + seeds +
         ".</p>\n" + endingTable(runs) + causeTable(runs) + "<h2>Figures</h2>\n" +
         figureTable(runFigures(), runs) +
         histogram(runFigures(), "execution [s]", runs, "Execution time of runs that finished",
                   "runs") +
         histogram(runFigures(), "closest [mm]", runs, "Smallest gap between two robots", "runs") +
         "<p>Below " + format("%.1f", limit_mm) + " mm the separation monitor stops all.</p>\n" +
         faultTable(runs) + brakingPart(experiment, runs) + waitTable(experiment, runs) +
         "</body></html>\n";
}

}  // namespace sylph_rehearsal
