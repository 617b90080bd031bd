#pragma once

#include <limits>
#include <string>

namespace sylph {

/// Numbers that a field or a parameter accepts: from `lowest` up to and with `highest`.
struct Range {
  double lowest = -std::numeric_limits<double>::max();  ///< still accepted, unless `open_below`
  double highest = std::numeric_limits<double>::max();  ///< still accepted
  bool open_below = false;                              ///< whether `lowest` itself is refused

  /// > 0.
  static Range positive() { return {0.0, std::numeric_limits<double>::max(), true}; }
  /// >= `lowest`.
  static Range atLeast(double lowest) { return {lowest}; }

  /// False for what is not finite, too.
  bool contains(double value) const;
};

/// In words that follow "must be": "> 0", ">= 1", "0 ... 1", "> 0 and <= 5", "finite".
std::string toString(const Range& range);

/// A number as a person would write it: "0.05", "1000", "400".
std::string shortNumber(double value);

}  // namespace sylph
