#include "sylph_natnet/echo_clock.hpp"

#include <cmath>

namespace sylph_natnet {
namespace {

/// Ticks and stamps are rounded.
constexpr double kRoundingS = 1e-6;

ClockEstimate estimateFrom(const EchoSample& sample, double now_s) {
  const double round_trip_s = sample.received_s - sample.sent_s;
  const double age_s = std::abs(now_s - sample.received_s);
  return {sample.sent_s + round_trip_s / 2.0 - sample.server_s,
          round_trip_s / 2.0 + age_s * EchoClock::kDriftPerS};
}

}  // namespace

void EchoClock::add(const EchoSample& sample) {
  if (!(sample.received_s >= sample.sent_s)) {
    return;
  }
  const std::optional<ClockEstimate> before = estimate(sample.received_s);
  const ClockEstimate after = estimateFrom(sample, sample.received_s);
  if (before && std::abs(before->offset_s - after.offset_s) >
                    before->uncertainty_s + after.uncertainty_s + kRoundingS) {
    samples_.clear();
  }
  samples_.push_back(sample);
  if (samples_.size() > kSamples) {
    samples_.pop_front();
  }
}

std::optional<ClockEstimate> EchoClock::estimate(double now_s) const {
  std::optional<ClockEstimate> best;
  for (const EchoSample& sample : samples_) {
    const ClockEstimate candidate = estimateFrom(sample, now_s);
    if (!best || candidate.uncertainty_s < best->uncertainty_s) {
      best = candidate;
    }
  }
  return best;
}

}  // namespace sylph_natnet
