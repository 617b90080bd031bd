#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace sylph {

/// The one random generator of the suite. It is always passed in: the same seed gives the same
/// result.
using Rng = std::mt19937;

// The standard fixes what std::mt19937 draws, but not what its distributions make of it. These
// three are the same with every standard library, so that computers of a lab agree on the starts
// and goals of a seed.

/// Uniform in 0 ... count - 1. `count` must be > 0.
inline std::size_t drawIndex(Rng& rng, std::size_t count) {
  const auto range = static_cast<std::uint64_t>(count);
  const std::uint64_t limit = (std::uint64_t{1} << 32) / range * range;  // a multiple: no bias
  std::uint64_t drawn = rng();
  while (drawn >= limit) {
    drawn = rng();
  }
  return static_cast<std::size_t>(drawn % range);
}

/// Uniform in [0, 1).
inline double drawFraction(Rng& rng) {
  return static_cast<double>(rng()) / 4294967296.0;
}

/// Puts the values into a random order.
template <typename T>
void shuffle(std::vector<T>& values, Rng& rng) {
  for (std::size_t rest = values.size(); rest > 1; --rest) {
    std::swap(values[rest - 1], values[drawIndex(rng, rest)]);
  }
}

}  // namespace sylph
