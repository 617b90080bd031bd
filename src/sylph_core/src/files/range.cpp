#include "sylph_core/files/range.hpp"

#include <cmath>
#include <sstream>

namespace sylph {

bool Range::contains(double value) const {
  const bool is_above = open_below ? value > lowest : value >= lowest;
  return std::isfinite(value) && is_above && value <= highest;
}

std::string toString(const Range& range) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const bool has_highest = range.highest < kLargest;
  if (range.lowest > -kLargest) {
    const std::string lowest = shortNumber(range.lowest);
    if (!has_highest) {
      return (range.open_below ? "> " : ">= ") + lowest;
    }
    const std::string highest = shortNumber(range.highest);
    return range.open_below ? "> " + lowest + " and <= " + highest : lowest + " ... " + highest;
  }
  return has_highest ? "<= " + shortNumber(range.highest) : "finite";
}

std::string shortNumber(double value) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::digits10);
  out << value;
  return out.str();
}

}  // namespace sylph
