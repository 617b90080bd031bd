#pragma once

#include <vector>

namespace sylph {

/// Social value orientation: the angle at which an agent weighs its own reward against its
/// partner's. He et al. 2024 (arXiv:2408.03063), "Socially-aware reward". Levels are spaced by 5
/// degrees, as in the authors' training code; the paper's table has 5 of them, that code 10.
constexpr double kSvoLevelSpacingDeg = 5.0;
constexpr int kSvoLevelCount = 10;  ///< 0, 5, ... 45 degrees
/// The level of an agent that rests on its goal: it steps aside for whoever has to pass.
constexpr int kMostProsocialLevel = kSvoLevelCount - 1;

/// Angle of a level, 0 (selfish) ... 45 (prosocial) [deg].
/// @throws std::out_of_range unless 0 <= level < kSvoLevelCount
double svoOfLevel(int level);

/// Mean angle of a distribution over the levels [deg]: the SVO that is shown.
/// @param probabilities  one per level, >= 0; they need not sum to 1
/// @throws std::invalid_argument unless there is one per level and their sum is finite and > 0
double meanSvo(const std::vector<float>& probabilities);

/// Reward of the social policy: both count alike, (own + partner's) / 2.
double socialReward(double own, double partner);

/// Reward of the action policy, redistributed by the executed SVO: cos(svo) own + sin(svo)
/// partner's.
/// @param svo_deg  0 ... 45 [deg]
double redistributedReward(double own, double partner, double svo_deg);

}  // namespace sylph
