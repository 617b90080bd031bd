#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace sylph {

/// The one random generator of the suite. It is always passed in: the same seed gives the same
/// result.
using Rng = std::mt19937;

// The standard fixes what std::mt19937 draws, but not what its distributions and std::shuffle make
// of it. These are the same with every standard library, so that computers of a lab agree on the
// maps, starts, goals and plans of a seed. Nothing else in the suite makes draws of an Rng.

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

/// Uniform in [low, high).
inline double drawBetween(Rng& rng, double low, double high) {
  return low + (high - low) * drawFraction(rng);
}

/// From the standard normal distribution (Box, Muller 1958, "A Note on the Generation of Random
/// Normal Deviates"). Two draws make one, so that there is nothing to keep in between.
inline double drawNormal(Rng& rng) {
  constexpr double kTwoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - drawFraction(rng)));
  return radius * std::cos(kTwoPi * drawFraction(rng));
}

/// From the standard Gumbel distribution. The largest of logits with such noise is a draw by their
/// softmax (Gumbel 1954), and their order one without replacement (Kool et al. 2019).
inline double drawGumbel(Rng& rng) {
  constexpr double kHalfStep = 0.5 / 4294967296.0;  // keeps the fraction off 0
  return -std::log(-std::log(drawFraction(rng) + kHalfStep));
}

/// An index in 0 ... count - 1, with a probability in proportion to its weight; where all weights
/// are 0, any with the same. `count` must be > 0.
/// @param weight  of an index: finite and >= 0
template <typename Weight>
std::size_t drawByWeight(Rng& rng, std::size_t count, Weight weight) {
  double total = 0.0;
  for (std::size_t index = 0; index < count; ++index) {
    total += static_cast<double>(weight(index));
  }
  if (total <= 0.0) {
    return drawIndex(rng, count);
  }
  double rest = drawFraction(rng) * total;
  std::size_t last = 0;  // of a weight > 0: rounding may lead past all of them
  for (std::size_t index = 0; index < count; ++index) {
    const auto own = static_cast<double>(weight(index));
    if (own > 0.0) {
      last = index;
      if (rest < own) {
        break;
      }
      rest -= own;
    }
  }
  return last;
}

/// Puts the values into a random order.
template <typename T>
void shuffle(std::vector<T>& values, Rng& rng) {
  for (std::size_t rest = values.size(); rest > 1; --rest) {
    std::swap(values[rest - 1], values[drawIndex(rng, rest)]);
  }
}

}  // namespace sylph
