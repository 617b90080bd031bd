#pragma once

#include <chrono>

namespace sylph {

/// How long a search may go on, in wall time from its making.
class Deadline {
 public:
  explicit Deadline(double limit_s) : start_(Clock::now()), limit_s_(limit_s) {}

  double elapsed() const {  ///< [s]
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  double remaining() const { return limit_s_ - elapsed(); }  ///< [s], negative when over
  bool isOver() const { return remaining() <= 0.0; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  double limit_s_;
};

}  // namespace sylph
