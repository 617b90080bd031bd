#include "histogram.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sylph_core/text/format.hpp"

namespace sylph_rehearsal {
namespace {

using sylph::format;

// Pixels.
constexpr double kLeft = 45.0;
constexpr double kTop = 26.0;
constexpr double kWidth = 640.0;
constexpr double kHeight = 150.0;
constexpr double kBelow = 45.0;
constexpr double kTickLength = 5.0;

constexpr double kMostBins = 25.0;
constexpr double kMostTicks = 10.0;
constexpr const char* kBarColor = "#0072b2";
constexpr const char* kMarkColor = "#d55e00";

/// The least of 1, 2, 5, 10, ... times a power of ten that is not below `least`.
double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

/// Bins of equal width that begin at a multiple of it.
struct Bins {
  double first;
  double width;
  std::vector<int> counts;

  double end() const { return first + width * static_cast<double>(counts.size()); }
  double toX(double value) const { return kLeft + kWidth * (value - first) / (end() - first); }
};

Bins binsOf(const std::vector<double>& sorted, const std::optional<HistogramMark>& mark) {
  const double low = mark ? std::min(sorted.front(), mark->value) : sorted.front();
  const double high = mark ? std::max(sorted.back(), mark->value) : sorted.back();
  // Where all are the same, a bin of a hundredth of it.
  const double spread = std::max(high - low, std::max(std::abs(high), 1.0) / 100.0);
  Bins bins;
  bins.width = roundStep(spread / kMostBins);
  bins.first = bins.width * std::floor(low / bins.width);
  const double last = std::floor((high - bins.first) / bins.width);
  bins.counts.resize(static_cast<std::size_t>(last) + 1);
  for (const double value : sorted) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, (value - bins.first) / bins.width));
    ++bins.counts[std::min(bin, bins.counts.size() - 1)];
  }
  return bins;
}

std::string number(double value) {
  return format("%.6g", value);
}

std::string text(double x, double y, const std::string& anchor, const std::string& content,
                 const std::string& color = "#222") {
  return "<text x=\"" + format("%.1f", x) + "\" y=\"" + format("%.1f", y) + "\" text-anchor=\"" +
         anchor + "\" fill=\"" + color + "\">" + content + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& color) {
  return "<line x1=\"" + format("%.1f", x1) + "\" y1=\"" + format("%.1f", y1) + "\" x2=\"" +
         format("%.1f", x2) + "\" y2=\"" + format("%.1f", y2) + "\" stroke=\"" + color + "\"/>\n";
}

std::string bars(const Bins& bins, int highest, const std::string& counted) {
  std::string svg;
  for (std::size_t bin = 0; bin < bins.counts.size(); ++bin) {
    if (bins.counts[bin] == 0) {
      continue;
    }
    const double from = bins.first + bins.width * static_cast<double>(bin);
    const double height = kHeight * bins.counts[bin] / highest;
    svg += "<rect x=\"" + format("%.1f", bins.toX(from) + 0.5) + "\" y=\"" +
           format("%.1f", kTop + kHeight - height) + "\" width=\"" +
           format("%.1f", bins.toX(from + bins.width) - bins.toX(from) - 1.0) + "\" height=\"" +
           format("%.1f", height) + "\" fill=\"" + kBarColor + "\"><title>" +
           std::to_string(bins.counts[bin]) + " " + counted + ": " + number(from) + " ... " +
           number(from + bins.width) + "</title></rect>\n";
  }
  return svg;
}

std::string axes(const Bins& bins, int highest, const std::string& axis,
                 const std::string& counted) {
  const double bottom = kTop + kHeight;
  std::string svg = line(kLeft, bottom, kLeft + kWidth, bottom, "#222");
  const double step = roundStep((bins.end() - bins.first) / kMostTicks);
  // By count, so that rounding does not add up.
  const double first = std::ceil(bins.first / step - 1e-9);
  for (double tick = first; tick * step <= bins.end() + 1e-9 * step; tick += 1.0) {
    const double x = bins.toX(tick * step);
    svg += line(x, bottom, x, bottom + kTickLength, "#222");
    svg += text(x, bottom + 18.0, "middle", number(tick * step + 0.0));  // never "-0"
  }
  svg += text(kLeft + kWidth / 2.0, bottom + 36.0, "middle", axis);
  svg += line(kLeft, kTop, kLeft, bottom, "#222");
  svg += text(kLeft - 6.0, kTop + 5.0, "end", std::to_string(highest));
  svg += text(kLeft - 6.0, bottom, "end", "0");
  return svg + text(kLeft - 6.0, kTop - 12.0, "end", counted);
}

std::string markLine(const Bins& bins, const HistogramMark& mark) {
  const double x = bins.toX(mark.value);
  const bool is_right = x > kLeft + kWidth / 2.0;
  return line(x, kTop - 20.0, x, kTop + kHeight, kMarkColor) +
         text(x + (is_right ? -5.0 : 5.0), kTop - 10.0, is_right ? "end" : "start", mark.label,
              kMarkColor);
}

}  // namespace

std::string histogramSvg(const std::vector<double>& sorted, const std::string& axis,
                         const std::string& counted, const std::optional<HistogramMark>& mark) {
  const Bins bins = binsOf(sorted, mark);
  const int highest = *std::max_element(bins.counts.begin(), bins.counts.end());
  const std::string width = format("%.0f", kLeft + kWidth + 20.0);
  const std::string height = format("%.0f", kTop + kHeight + kBelow);
  return R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + " " + height + "\" font-size=\"13\">\n" +
         bars(bins, highest, counted) + axes(bins, highest, axis, counted) +
         (mark ? markLine(bins, *mark) : std::string()) + "</svg>\n";
}

}  // namespace sylph_rehearsal
