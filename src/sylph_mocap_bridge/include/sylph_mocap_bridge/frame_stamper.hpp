#pragma once

#include <optional>

#include "sylph_mocap_bridge/clock_sync.hpp"
#include "sylph_natnet/types.hpp"

namespace sylph_mocap_bridge {

/// What a pose's stamp means.
enum class StampPolicy {
  Receive,             ///< when it came
  LatencyCompensated,  ///< when it came, less the time that the server says it kept it
  ClockSync,           ///< when the cameras saw it, by the server's clock related to local time
};

/// Instants of one frame [s].
struct FrameTimes {
  double exposure_s = 0.0;  ///< server's clock: when the cameras saw it
  double transmit_s = 0.0;  ///< server's clock: when it was sent
};

/// By the ticks where the frame has them, else (before 3.0) by its timestamp and latency. An
/// unknown exposure (playback, some cameras) is taken to be the next later instant that is known.
/// @param ticks_per_s  0 if not known
FrameTimes timesOf(const sylph_natnet::Frame& frame, std::uint64_t ticks_per_s);

/// Gives frames their stamps in local (ROS) time.
class FrameStamper {
 public:
  FrameStamper(StampPolicy policy, const ClockSyncOptions& options)
      : policy_(policy), clock_(options) {}

  /// @param arrival_s  local time
  /// @param echo       offset from the server's clock to local time, if echoes show it
  /// @return stamp of the exposure; nothing until the clocks are known
  std::optional<double> stamp(const FrameTimes& times, double arrival_s,
                              const std::optional<sylph_natnet::ClockEstimate>& echo);

  /// The server's clock or the local one began anew.
  void reset() { clock_.reset(); }

  /// Offset from the server's clock to local time. @return nothing until known
  std::optional<sylph_natnet::ClockEstimate> clock() const { return clock_.estimate(); }

 private:
  StampPolicy policy_;
  ClockSync clock_;
};

}  // namespace sylph_mocap_bridge
