#pragma once

#include <cstdint>

namespace sylph_ros {

/// Whether an enumerator has the value of a message's constant, for static_assert.
template <typename Enumerator>
constexpr bool isSame(Enumerator enumerator, std::uint8_t constant) {
  return static_cast<std::uint8_t>(enumerator) == constant;
}

}  // namespace sylph_ros
