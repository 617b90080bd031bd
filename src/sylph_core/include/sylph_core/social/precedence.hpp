#pragma once

namespace sylph {

/// The rule of priorities: the SVO that lets crowds get on. Whoever is on its goal is most
/// prosocial; off it one begins nearly as prosocial, and the higher one's priority becomes the more
/// selfish one is: a level for every 20 timesteps, in each level spread by the agent's tie break,
/// so that no two are alike for good. PIBT solves as much in this order as in that of priorities.
/// @param priority   as in PIBT: timesteps since the agent was last on its goal, 0 if it is there
/// @param tie_break  0 ... 1
/// @return 0 ... 45 [deg]
float svoByPriority(int priority, float tie_break);

/// An SVO as a distribution over two neighbouring levels, whose mean angle it is.
/// @param svo_deg        0 ... 45 [deg]
/// @param probabilities  out: kSvoLevelCount numbers of sum 1
void spreadOverLevels(float svo_deg, float* probabilities);

}  // namespace sylph
