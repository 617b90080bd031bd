#include "sylph_mocap_bridge/rate_gate.hpp"

#include <cmath>

namespace sylph_mocap_bridge {
namespace {

/// Share of a period by which an event may come early: 120 Hz through a gate of 60 Hz is every
/// second one, whatever the rounding.
constexpr double kEarly = 0.1;

}  // namespace

bool RateGate::passes(double time_s) {
  // Far from the expected time there was a pause, or time went back.
  if (std::abs(time_s - next_s_) > 2.0 * period_s_) {
    next_s_ = time_s;
  }
  if (time_s < next_s_ - kEarly * period_s_) {
    return false;
  }
  next_s_ += period_s_;
  return true;
}

}  // namespace sylph_mocap_bridge
