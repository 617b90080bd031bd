#pragma once

namespace sylph_mocap_bridge {

/// Lets events through at a rate, by their own time stamps.
class RateGate {
 public:
  /// @param rate_hz  0: all
  explicit RateGate(double rate_hz) : period_s_(rate_hz > 0.0 ? 1.0 / rate_hz : 0.0) {}

  /// @return whether the event at `time_s` passes
  bool passes(double time_s);

 private:
  double period_s_;
  double next_s_ = 0.0;
};

}  // namespace sylph_mocap_bridge
