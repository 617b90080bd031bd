#pragma once

#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace sylph {

/// All of a file, empty if it cannot be read.
inline std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Waits until a process has ended, reaped or not.
/// @param path  of a file with the process id
/// @return      false if it still runs after 20 s
inline bool endsSoon(const std::string& path) {
  const std::string stat = "/proc/" + std::to_string(std::stoi(contentOf(path))) + "/stat";
  const auto hasEnded = [&] {
    const std::string content = contentOf(stat);
    return content.empty() || content.find(") Z ") != std::string::npos;
  };
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!hasEnded() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::yield();
  }
  return hasEnded();
}

}  // namespace sylph
