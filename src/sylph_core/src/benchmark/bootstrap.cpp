#include "sylph_core/benchmark/bootstrap.hpp"

#include <algorithm>
#include <cstddef>

namespace sylph {

std::optional<Interval> bootstrapMean(const std::vector<double>& values, Rng& rng) {
  constexpr std::size_t kSamples = 2000;
  constexpr std::size_t kCutOff = kSamples / 40;  // 2.5 % at each end
  if (values.size() < 2) {
    return std::nullopt;
  }
  std::vector<double> means(kSamples, 0.0);
  for (double& mean : means) {
    for (std::size_t draw = 0; draw < values.size(); ++draw) {
      mean += values[drawIndex(rng, values.size())];
    }
    mean /= static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return Interval{means[kCutOff], means[kSamples - 1 - kCutOff]};
}

}  // namespace sylph
