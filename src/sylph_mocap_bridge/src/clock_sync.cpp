#include "sylph_mocap_bridge/clock_sync.hpp"

#include <algorithm>
#include <cmath>

namespace sylph_mocap_bridge {
namespace {

/// The quantile is taken anew every so many frames: it hardly moves between.
constexpr std::size_t kFramesPerUpdate = 16;
/// Echoes that leave more than this open are not better than the frames.
constexpr double kLargestEchoUncertaintyS = 0.005;

}  // namespace

ClockSync::ClockSync(const ClockSyncOptions& options) : options_(options) {
  offsets_s_.reserve(options_.window);
}

void ClockSync::reset() {
  offsets_s_.clear();
  added_ = 0;
}

void ClockSync::add(double server_s, double local_s,
                    const std::optional<sylph_natnet::ClockEstimate>& echo) {
  const double offset_s = local_s - server_s;
  if (offsets_s_.size() < options_.window) {
    offsets_s_.push_back(offset_s);
  } else {
    offsets_s_[added_ % options_.window] = offset_s;
  }
  const bool settling = added_ < options_.least_samples;
  if (settling || added_ % kFramesPerUpdate == 0) {
    target_ = offsetOfFrames();
    if (echo && echo->uncertainty_s < kLargestEchoUncertaintyS) {
      target_ = *echo;
    }
  }
  const double error_s = target_.offset_s - offset_s_;
  const double largest_s = options_.slew_s_per_s * std::max(0.0, server_s - server_s_);
  const bool at_once = settling || std::abs(error_s) > options_.step_s;
  offset_s_ += at_once ? error_s : std::clamp(error_s, -largest_s, largest_s);
  server_s_ = server_s;
  ++added_;
}

sylph_natnet::ClockEstimate ClockSync::offsetOfFrames() {
  sorted_s_ = offsets_s_;
  std::sort(sorted_s_.begin(), sorted_s_.end());
  const auto at = [this](double quantile) {
    const auto last = static_cast<double>(sorted_s_.size() - 1);
    return sorted_s_[static_cast<std::size_t>(std::clamp(quantile, 0.0, 1.0) * last)];
  };
  // Half of the offsets lie within this of the one that counts.
  const double spread_s = std::max(at(options_.quantile + 0.25) - at(options_.quantile),
                                   at(options_.quantile) - at(options_.quantile - 0.25));
  return {at(options_.quantile), spread_s};
}

std::optional<double> ClockSync::toLocal(double server_s) const {
  if (added_ < options_.least_samples) {
    return std::nullopt;
  }
  return server_s + offset_s_;
}

std::optional<sylph_natnet::ClockEstimate> ClockSync::estimate() const {
  if (added_ < options_.least_samples) {
    return std::nullopt;
  }
  return sylph_natnet::ClockEstimate{offset_s_, target_.uncertainty_s};
}

}  // namespace sylph_mocap_bridge
