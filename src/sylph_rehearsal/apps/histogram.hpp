#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sylph_rehearsal {

/// A line across a histogram.
struct HistogramMark {
  double value;
  std::string label;
};

/// How values are distributed, as an SVG image that stands in an HTML page by itself.
/// @param sorted  ascending and finite, not empty
/// @param axis    what they are, with the unit
/// @param counted what there is one of for each value, such as "runs"
std::string histogramSvg(const std::vector<double>& sorted, const std::string& axis,
                         const std::string& counted,
                         const std::optional<HistogramMark>& mark = std::nullopt);

}  // namespace sylph_rehearsal
