#pragma once

#include <algorithm>
#include <functional>
#include <utility>

namespace sylph {

/// Tells a time that never goes back [s].
using Clock = std::function<double()>;

/// Wall time.
double steadyTime();

/// How long a search may go on, from its making. Searches ask it between pieces of work that take
/// far less than a hundredth of a second, whatever the size of the instance.
class Deadline {
 public:
  /// @param clock  another one than wall time: for tests that count in questions
  explicit Deadline(double limit_s, Clock clock = steadyTime)
      : clock_(std::move(clock)), start_s_(clock_()), limit_s_(limit_s) {}

  /// A part of the time that is left: from now on for so long, but not longer than this one.
  Deadline within(double limit_s) const { return Deadline(std::min(limit_s, remaining()), clock_); }

  /// The same, ending so much later.
  Deadline extended(double by_s) const {
    Deadline later = *this;
    later.limit_s_ += by_s;
    return later;
  }

  double elapsed() const { return clock_() - start_s_; }     ///< [s]
  double remaining() const { return limit_s_ - elapsed(); }  ///< [s], negative when over
  bool isOver() const { return remaining() <= 0.0; }

 private:
  Clock clock_;
  double start_s_;
  double limit_s_;
};

}  // namespace sylph
