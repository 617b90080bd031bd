#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace sylph {

/// A whole number that `Integer` can hold. json's own get() cuts fractions off, lets what is too
/// large wrap, and what it makes of 1e300 is not defined.
/// @throws std::invalid_argument with the value and the bounds
template <typename Integer>
Integer integerOf(const nlohmann::json& value) {
  constexpr Integer kLowest = std::numeric_limits<Integer>::min();
  constexpr Integer kHighest = std::numeric_limits<Integer>::max();
  // Of a file, numbers without a sign are "unsigned"; an "integer" that is not is negative.
  const bool fits = value.is_number_unsigned()
                        ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(kHighest)
                        : std::is_signed_v<Integer> && value.is_number_integer() &&
                              value.get<std::int64_t>() >= static_cast<std::int64_t>(kLowest);
  if (!fits) {
    constexpr std::size_t kLongest = 40;
    throw std::invalid_argument(value.dump().substr(0, kLongest) + ": must be a whole number " +
                                std::to_string(kLowest) + " ... " + std::to_string(kHighest));
  }
  return value.get<Integer>();
}

/// A list of them.
/// @throws nlohmann::json::exception if it is no list
template <typename Integer>
std::vector<Integer> integersOf(const nlohmann::json& list) {
  std::vector<Integer> integers;
  for (const nlohmann::json& value : list.get_ref<const nlohmann::json::array_t&>()) {
    integers.push_back(integerOf<Integer>(value));
  }
  return integers;
}

}  // namespace sylph
