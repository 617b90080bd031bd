#include "sylph_core/control/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sylph_core/control/time_jump.hpp"

namespace sylph {
namespace {

/// Time over which velocity is measured [s]: long against the noise of a pose, short against
/// braking.
constexpr double kVelocityWindow = 0.06;
/// A robot that was not seen for longer may have stopped meanwhile: what came before says nothing
/// of its velocity [s].
constexpr double kLongestGap_s = 2.0 * kVelocityWindow;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

SeparationWatch::SeparationWatch(const std::vector<Footprint>& sizes,
                                 const SeparationLimits& limits)
    : limits_(limits), closest_ever_{-1, -1, kInfinity} {
  for (const Footprint& size : sizes) {
    Track track;
    track.footprint = size;
    track.radius_m = std::hypot(size.length_m, size.width_m) / 2.0;
    tracks_.push_back(track);
  }
}

bool SeparationWatch::update(int robot, const Pose2d& pose, double stamp_s) {
  Track& track = tracks_.at(index(robot));
  const bool is_late = !track.samples.empty() && stamp_s <= track.samples.back().stamp_s &&
                       stamp_s > track.samples.back().stamp_s - kTimeJump_s;
  if (!isFinite(pose) || !std::isfinite(stamp_s) || is_late) {
    return false;
  }
  // Time may also have been set back, as in a replay: what came before belongs to another time.
  if (!track.samples.empty() && (stamp_s < track.samples.back().stamp_s ||
                                 stamp_s > track.samples.back().stamp_s + kLongestGap_s)) {
    track.samples.clear();
  }
  track.samples.push_back({pose, stamp_s});
  while (track.samples.size() > 2 && stamp_s - track.samples[1].stamp_s >= kVelocityWindow) {
    track.samples.pop_front();
  }
  track.footprint.center = position(pose);
  track.footprint.yaw_rad = pose.yaw_rad;

  track.stopped = whereItStops(track);
  track.reserve_m = distance(track.stopped.center, track.footprint.center);

  std::optional<PairGap> too_close;
  for (int other = 0; other < static_cast<int>(tracks_.size()); ++other) {
    const Track& neighbor = tracks_[index(other)];
    if (other == robot || neighbor.samples.empty()) {
      continue;
    }
    // Circles around the footprints: most pairs are far apart, and exact gaps cost more than all
    // the rest.
    const double lowest_m = lowestGap(track, neighbor);
    if (lowest_m > std::max(limits_.limit_m, track.reserve_m + neighbor.reserve_m) &&
        lowest_m > closest_ever_.gap_m) {
      continue;
    }
    const PairGap pair = {std::min(robot, other), std::max(robot, other),
                          footprintGap(track.footprint, neighbor.footprint)};
    if (pair.gap_m < closest_ever_.gap_m) {
      closest_ever_ = pair;
    }
    if (pair.gap_m < limits_.limit_m || footprintGap(track.stopped, neighbor.stopped) <= 0.0) {
      too_close = too_close && too_close->gap_m < pair.gap_m ? too_close : pair;
    }
  }
  track.too_close_in_a_row = too_close ? track.too_close_in_a_row + 1 : 0;
  // One bad pose must not stop the lab.
  if (track.too_close_in_a_row < limits_.confirmations) {
    return false;
  }
  violation_ = too_close;
  return true;
}

PairGap SeparationWatch::closest() const {
  PairGap closest{-1, -1, kInfinity};
  for (std::size_t a = 0; a < tracks_.size(); ++a) {
    for (std::size_t b = a + 1; b < tracks_.size(); ++b) {
      if (tracks_[a].samples.empty() || tracks_[b].samples.empty() ||
          lowestGap(tracks_[a], tracks_[b]) >= closest.gap_m) {
        continue;
      }
      const double gap_m = footprintGap(tracks_[a].footprint, tracks_[b].footprint);
      if (gap_m < closest.gap_m) {
        closest = {static_cast<int>(a), static_cast<int>(b), gap_m};
      }
    }
  }
  return closest;
}

Footprint SeparationWatch::whereItStops(const Track& track) const {
  Footprint stopped = track.footprint;
  const Sample& first = track.samples.front();
  const Sample& last = track.samples.back();
  const double duration_s = last.stamp_s - first.stamp_s;
  if (duration_s <= 0.0) {
    return stopped;
  }
  const Vector2 velocity_mps =
      1.0 / duration_s * displacement(position(first.pose), position(last.pose));
  // The least: a pose that was missed does not make the next ones come more slowly.
  double pose_period_s = duration_s;
  for (std::size_t i = 1; i < track.samples.size(); ++i) {
    pose_period_s =
        std::min(pose_period_s, track.samples[i].stamp_s - track.samples[i - 1].stamp_s);
  }
  const double time_s = limits_.command_latency_s + limits_.stop_response_s +
                        limits_.confirmations * pose_period_s +
                        norm(velocity_mps) / (2.0 * limits_.stop_deceleration_mps2);
  stopped.center = stopped.center + time_s * velocity_mps;
  return stopped;
}

double SeparationWatch::lowestGap(const Track& a, const Track& b) {
  return distance(a.footprint.center, b.footprint.center) - a.radius_m - b.radius_m;
}

}  // namespace sylph
