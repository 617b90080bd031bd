#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace sylph_robot_node {

/// Waits for a condition to become true.
/// @return false if it has not within 20 s
inline bool waitUntil(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace sylph_robot_node
