#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sylph_natnet/echo_clock.hpp"

namespace sylph_mocap_bridge {

/// How the offset between two clocks is found and followed.
struct ClockSyncOptions {
  /// Which of the last offsets counts, 0 ... 1. 0, the least: delays only ever add, as on real
  /// computers. 0.5, the median: the local clock itself moves in steps, as in simulation.
  double quantile = 0.0;
  std::size_t window = 1024;       ///< how many frames the quantile is taken of, > 0
  std::size_t least_samples = 20;  ///< frames before the first answer, > 0
  double slew_s_per_s = 0.002;     ///< how fast the offset may change, > 0
  double step_s = 0.1;             ///< by more than this it is set at once, > 0
};

/// Local time (ROS) of the camera system's instants, smooth although frames arrive in bunches.
///
/// The offset between the clocks comes from echoes where they show it to within 5 ms, else from the
/// frames' own arrival: a quantile of (arrival - transmission) over a sliding window. The offset in
/// use follows it slowly, so that stamps keep the cameras' rhythm.
class ClockSync {
 public:
  explicit ClockSync(const ClockSyncOptions& options);

  /// Takes a frame's transmission time by the server and its arrival by the local clock.
  /// @param echo  offset that echoes show, to the local clock
  void add(double server_s, double local_s,
           const std::optional<sylph_natnet::ClockEstimate>& echo = std::nullopt);

  /// @return nothing until enough is known
  std::optional<double> toLocal(double server_s) const;
  /// Offset in use. @return nothing until enough is known
  std::optional<sylph_natnet::ClockEstimate> estimate() const;

  /// Forgets all, as after a change of one of the clocks.
  void reset();

 private:
  sylph_natnet::ClockEstimate offsetOfFrames();

  ClockSyncOptions options_;
  std::vector<double> offsets_s_;  ///< ring
  std::vector<double> sorted_s_;   ///< scratch of offsetOfFrames()
  std::size_t added_ = 0;
  sylph_natnet::ClockEstimate target_;
  double offset_s_ = 0.0;
  double server_s_ = 0.0;
};

}  // namespace sylph_mocap_bridge
