#pragma once

#include <deque>
#include <optional>

namespace sylph_natnet {

/// One echo. Local times are of one steady clock, the server's of its ticks [s].
struct EchoSample {
  double sent_s = 0;      ///< request, local time
  double server_s = 0;    ///< answer, time of the server
  double received_s = 0;  ///< answer, local time
};

/// How far the local clock is ahead of the server's.
struct ClockEstimate {
  double offset_s = 0;       ///< local time = server time + offset
  double uncertainty_s = 0;  ///< the true offset is within +- this, if the clocks keep the rate
};

/// Finds the server's clock by echoes. An echo that went forth and back in time d shows the offset
/// to within d / 2, however unlike the two ways are. Of the last echoes the one that shows it best
/// now counts, where age costs as much as clocks may drift apart.
class EchoClock {
 public:
  static constexpr std::size_t kSamples = 64;  ///< Echoes that are remembered
  /// Quartz clocks of two computers: up to 50 ppm apart.
  static constexpr double kDriftPerS = 50e-6;

  /// An echo that contradicts the others shows that the server's clock was set or restarted: it
  /// begins a new history. One whose answer precedes its request is ignored.
  void add(const EchoSample& sample);
  /// Forgets all echoes, as after a change of servers.
  void reset() { samples_.clear(); }

  /// @param now_s  local time
  /// @return nothing before the first echo
  std::optional<ClockEstimate> estimate(double now_s) const;

 private:
  std::deque<EchoSample> samples_;
};

}  // namespace sylph_natnet
