#include "sylph_training/smp3o/advantages.hpp"

#include <stdexcept>
#include <string>

namespace sylph_training {

std::vector<float> generalizedAdvantages(const std::vector<float>& rewards,
                                         const std::vector<float>& values, float end_value,
                                         double gamma, double lambda) {
  if (rewards.size() != values.size()) {
    throw std::invalid_argument(std::to_string(rewards.size()) + " rewards and " +
                                std::to_string(values.size()) + " values: must be as many");
  }
  std::vector<float> advantages(rewards.size());
  auto next_value = static_cast<double>(end_value);
  double advantage = 0.0;
  for (std::size_t step = rewards.size(); step-- > 0;) {
    const auto value = static_cast<double>(values[step]);
    const double delta = static_cast<double>(rewards[step]) + gamma * next_value - value;
    advantage = delta + gamma * lambda * advantage;
    advantages[step] = static_cast<float>(advantage);
    next_value = value;
  }
  return advantages;
}

}  // namespace sylph_training
