#pragma once

#include <optional>
#include <vector>

#include "sylph_core/grid/rng.hpp"

namespace sylph {

/// From `low` to `high`.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Interval in which the mean of a sample's population lies with 95 % confidence: between the 2.5th
/// and the 97.5th percentile of the means of 2000 samples drawn from this one with replacement
/// (Efron 1979, "Bootstrap Methods: Another Look at the Jackknife").
/// @return nothing for fewer than two values, which say nothing about their spread
std::optional<Interval> bootstrapMean(const std::vector<double>& values, Rng& rng);

}  // namespace sylph
