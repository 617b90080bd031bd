#pragma once

#include <string>

/// Checks of option values that need no ROS. All throw std::invalid_argument with one line: name,
/// value, what is allowed.
namespace sylph_sim {

void requirePositive(const std::string& name, double value);
void requireNotNegative(const std::string& name, double value);
void requireInRange(const std::string& name, double value, double low, double high);

}  // namespace sylph_sim
