#include "benchmark/text_table.hpp"

#include <algorithm>
#include <numeric>

#include "sylph_core/benchmark/bootstrap.hpp"
#include "sylph_core/text/format.hpp"

namespace sylph {

std::string alignTable(const std::vector<std::vector<std::string>>& rows) {
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

std::vector<std::string> meanCells(const std::vector<double>& values) {
  if (values.empty()) {
    return {"-", "-"};
  }
  Rng rng(0);  // the same runs give the same table
  const std::optional<Interval> interval = bootstrapMean(values, rng);
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {format("%.3f", sum / static_cast<double>(values.size())),
          interval ? format("%.3f", interval->low) + ".." + format("%.3f", interval->high) : "-"};
}

}  // namespace sylph
