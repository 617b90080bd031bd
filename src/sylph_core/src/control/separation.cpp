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
/// Neighbours are looked for in cells of four times this at least [m].
constexpr double kLeastRadius_m = 0.05;

double radiusOf(const Footprint& size) {
  return std::hypot(size.length_m, size.width_m) / 2.0;
}

/// Of the circle around a robot and the way that it needs to stop, mostly.
double usualReach(const std::vector<Footprint>& sizes) {
  double largest_m = kLeastRadius_m;
  for (const Footprint& size : sizes) {
    largest_m = std::max(largest_m, radiusOf(size));
  }
  return 2.0 * largest_m;
}

}  // namespace

double stoppingDistance(const SeparationLimits& limits, double speed_mps) {
  return speed_mps * (limits.command_latency_s + limits.stop_response_s +
                      speed_mps / (2.0 * limits.stop_deceleration_mps2));
}

SeparationWatch::SeparationWatch(const std::vector<Footprint>& sizes,
                                 const SeparationLimits& limits)
    : limits_(limits), reaches_(usualReach(sizes)), closest_ever_{-1, -1, kInfinity} {
  for (const Footprint& size : sizes) {
    Track track;
    track.footprint = size;
    track.radius_m = radiusOf(size);
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

  reaches_.put(robot, track.footprint.center, track.radius_m + track.reserve_m);

  std::optional<PairGap> too_close;
  // Whoever is farther away neither comes too close nor closer than any pair did before.
  const double reach_m =
      track.radius_m + std::max({limits_.limit_m, closest_ever_.gap_m, track.reserve_m});
  for (const int other : reaches_.near(track.footprint.center, reach_m)) {
    if (other == robot) {
      continue;
    }
    const Track& neighbor = tracks_[index(other)];
    // Circles around the footprints: exact gaps cost more than all the rest.
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
  for (int robot = 0; robot < static_cast<int>(tracks_.size()); ++robot) {
    const Track& track = tracks_[index(robot)];
    if (track.samples.empty()) {
      continue;
    }
    for (const int other : reaches_.near(track.footprint.center, track.radius_m + closest.gap_m)) {
      const Track& neighbor = tracks_[index(other)];
      if (other <= robot || lowestGap(track, neighbor) >= closest.gap_m) {
        continue;
      }
      const double gap_m = footprintGap(track.footprint, neighbor.footprint);
      if (gap_m < closest.gap_m) {
        closest = {robot, other, gap_m};
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
