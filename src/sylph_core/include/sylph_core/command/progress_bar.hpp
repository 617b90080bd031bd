#pragma once

#include <unistd.h>

#include <cstddef>
#include <iostream>
#include <string>

namespace sylph {

/// How far a command has come, on standard error: a bar on a terminal, a line for each tenth
/// elsewhere.
class ProgressBar {
 public:
  /// @param total  of what show() counts
  explicit ProgressBar(std::size_t total)
      : total_(total), is_terminal_(isatty(STDERR_FILENO) == 1) {}

  /// Draws the bar at `done` of the total.
  void show(std::size_t done) {
    const std::size_t tenths = total_ == 0 ? kParts : done * kParts / total_;
    if (is_terminal_) {
      const std::size_t filled = total_ == 0 ? kWidth : done * kWidth / total_;
      std::cerr << "\r[" << std::string(filled, '#') << std::string(kWidth - filled, '.') << "] "
                << done << " / " << total_ << (done == total_ ? "\n" : "") << std::flush;
    } else if (tenths > shown_tenths_) {
      std::cerr << done << " / " << total_ << " runs\n";
    }
    shown_tenths_ = tenths;
  }

 private:
  static constexpr std::size_t kParts = 10;
  static constexpr std::size_t kWidth = 40;

  std::size_t total_;
  bool is_terminal_;
  std::size_t shown_tenths_ = 0;
};

}  // namespace sylph
