#pragma once

#include <functional>
#include <string>

#include "sylph_core/files/range.hpp"

namespace sylph_sim {

/// Is shown each number of some options: its name, its value, what is allowed, what it means. So a
/// bound stands once, for whoever reads the options and for whoever checks them.
using NumberVisitor = std::function<void(const std::string& name, double& value,
                                         const sylph::Range& range, const std::string& meaning)>;

/// @throws std::invalid_argument with one line: name, value, what is allowed
void requireWithin(const std::string& name, double value, const sylph::Range& range,
                   const std::string& meaning = "");

/// Checks each number that visitNumbers() shows of some options.
/// @throws std::invalid_argument as requireWithin()
template <typename Options>
void requireNumbersWithin(Options options) {
  visitNumbers(options, requireWithin);
}

}  // namespace sylph_sim
