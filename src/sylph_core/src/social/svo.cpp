#include "sylph_core/social/svo.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace sylph {
namespace {

constexpr double kRadPerDeg = 0.017453292519943295;

}  // namespace

double svoOfLevel(int level) {
  if (level < 0 || level >= kSvoLevelCount) {
    throw std::out_of_range("SVO level " + std::to_string(level) + ": must be 0 ... " +
                            std::to_string(kSvoLevelCount - 1));
  }
  return level * kSvoLevelSpacingDeg;
}

double meanSvo(const std::vector<float>& probabilities) {
  const double sum = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
  if (probabilities.size() != kSvoLevelCount || !std::isfinite(sum) || sum <= 0.0) {
    throw std::invalid_argument(std::to_string(probabilities.size()) +
                                " SVO probabilities of sum " + std::to_string(sum) + ": must be " +
                                std::to_string(kSvoLevelCount) + " of a sum > 0");
  }
  double mean_deg = 0.0;
  for (int level = 0; level < kSvoLevelCount; ++level) {
    mean_deg += probabilities[static_cast<std::size_t>(level)] / sum * svoOfLevel(level);
  }
  return mean_deg;
}

double socialReward(double own, double partner) {
  return (own + partner) / 2.0;
}

double redistributedReward(double own, double partner, double svo_deg) {
  const double svo_rad = svo_deg * kRadPerDeg;
  return std::cos(svo_rad) * own + std::sin(svo_rad) * partner;
}

}  // namespace sylph
