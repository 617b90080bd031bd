#include "sylph_core/social/precedence.hpp"

#include <algorithm>

#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

constexpr int kTimestepsPerLevel = 20;
constexpr float kSpread = 0.9F;  // levels that a tie break covers: less than from one to the next
constexpr auto kSpacing_deg = static_cast<float>(kSvoLevelSpacingDeg);

}  // namespace

float svoByPriority(int priority, float tie_break) {
  constexpr int kHighest = kMostProsocialLevel - 1;  // off the goal
  if (priority == 0) {
    return kSpacing_deg * kMostProsocialLevel;
  }
  const int level = kHighest - std::min(kHighest, priority / kTimestepsPerLevel);
  return kSpacing_deg * (static_cast<float>(level) + kSpread * tie_break);
}

void spreadOverLevels(float svo_deg, float* probabilities) {
  std::fill(probabilities, probabilities + kSvoLevelCount, 0.F);
  const float level =
      std::clamp(svo_deg / kSpacing_deg, 0.F, static_cast<float>(kMostProsocialLevel));
  const int below = std::min(static_cast<int>(level), kMostProsocialLevel - 1);
  // Two levels whose mean it is: the network learns a distribution, and one level alone would round
  // the tie break away.
  probabilities[below + 1] = level - static_cast<float>(below);
  probabilities[below] = 1.F - probabilities[below + 1];
}

}  // namespace sylph
