#pragma once

#include <vector>

namespace sylph_training {

/// Generalised advantage estimates of one agent along steps without interruption: A_t = delta_t +
/// gamma lambda A_(t+1) with delta_t = r_t + gamma V_(t+1) - V_t. Schulman et al. 2016
/// (arXiv:1506.02438), Eq. 16.
///
/// @param rewards    of each step
/// @param values     of the state before each step, as many
/// @param end_value  of the state after the last step: 0 if the episode is solved
/// @param gamma      discount of rewards, 0 ... 1
/// @param lambda     0: one step, most biased; 1: all steps, most scattered
/// @throws std::invalid_argument if there are not as many rewards as values
std::vector<float> generalizedAdvantages(const std::vector<float>& rewards,
                                         const std::vector<float>& values, float end_value,
                                         double gamma, double lambda);

}  // namespace sylph_training
