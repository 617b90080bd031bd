#include "sylph_mocap_bridge/frame_stamper.hpp"

#include <algorithm>

namespace sylph_mocap_bridge {

FrameTimes timesOf(const sylph_natnet::Frame& frame, std::uint64_t ticks_per_s) {
  if (ticks_per_s == 0 || frame.transmit_ticks == 0) {
    const double latency_s = std::max(0.0, static_cast<double>(frame.latency_s));
    return {frame.timestamp_s, frame.timestamp_s + latency_s};
  }
  std::uint64_t exposure_ticks = frame.transmit_ticks;
  if (frame.mid_exposure_ticks != 0) {
    exposure_ticks = frame.mid_exposure_ticks;
  } else if (frame.data_received_ticks != 0) {
    exposure_ticks = frame.data_received_ticks;
  }
  const auto ticks = static_cast<double>(ticks_per_s);
  return {static_cast<double>(exposure_ticks) / ticks,
          static_cast<double>(frame.transmit_ticks) / ticks};
}

std::optional<double> FrameStamper::stamp(const FrameTimes& times, double arrival_s,
                                          const std::optional<sylph_natnet::ClockEstimate>& echo) {
  clock_.add(times.transmit_s, arrival_s, echo);
  switch (policy_) {
    case StampPolicy::Receive:
      return arrival_s;
    case StampPolicy::LatencyCompensated:
      return arrival_s - (times.transmit_s - times.exposure_s);
    case StampPolicy::ClockSync:
      break;
  }
  return clock_.toLocal(times.exposure_s);
}

}  // namespace sylph_mocap_bridge
