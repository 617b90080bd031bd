#pragma once

#include <chrono>
#include <thread>

namespace sylph_ros {

/// Waits for a condition to become true, in tests of what other threads and nodes do.
/// @param meanwhile  is called until then: a pause, messages to handle
/// @return whether it does before 20 s of wall time have passed
template <typename Condition, typename Meanwhile>
bool waitUntil(const Condition& condition, const Meanwhile& meanwhile) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) {
      return false;
    }
    meanwhile();
  }
  return true;
}

/// While others serve the messages.
template <typename Condition>
bool waitUntil(const Condition& condition) {
  return waitUntil(condition, [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); });
}

}  // namespace sylph_ros
