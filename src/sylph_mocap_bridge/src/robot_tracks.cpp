#include "sylph_mocap_bridge/robot_tracks.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace sylph_mocap_bridge {
namespace {

/// A body that is seen less than this share of the time is worth a word.
constexpr double kGoodRatio = 0.95;

std::uint64_t badOf(const TrackCounts& counts) {
  return counts.untracked + counts.malformed + counts.stale + counts.ahead + counts.frozen +
         counts.unordered;
}

/// A driver on another computer stamps by that one's clock, or by ticks since that one was started.
std::string offBySeconds(double seconds, const char* direction) {
  char text[128];
  std::snprintf(text, sizeof(text),
                "its stamps are %.3g s %s: the clocks of two computers differ, or the driver "
                "stamps by another one",
                seconds, direction);
  return text;
}

/// Why most of the bad ones were bad.
std::string mainCause(const TrackCounts& now, const TrackCounts& before) {
  std::pair<std::uint64_t, std::string> most{0, "no data"};
  for (const auto& [count, cause] :
       {std::pair<std::uint64_t, std::string>{now.untracked - before.untracked,
                                              "the cameras do not track it"},
        {now.malformed - before.malformed, "its pose is not a number or no rotation"},
        {now.stale - before.stale, offBySeconds(now.last_age_s, "old")},
        {now.ahead - before.ahead, offBySeconds(-now.last_age_s, "ahead")},
        {now.frozen - before.frozen, "its pose is frozen"},
        {now.unordered - before.unordered, "its stamps do not advance"}}) {
    if (count > most.first) {
      most = {count, cause};
    }
  }
  return most.second;
}

}  // namespace

double goodRatio(const TrackCounts& now, const TrackCounts& before) {
  const auto good = static_cast<double>(now.good - before.good);
  const auto bad = static_cast<double>(badOf(now) - badOf(before));
  return good > 0.0 ? good / (good + bad) : 0.0;
}

std::string bodyProblem(const TrackCounts& now, const TrackCounts& before) {
  const double ratio = goodRatio(now, before);
  if (ratio >= kGoodRatio) {
    return "";
  }
  return std::string(ratio > 0.0 ? "is lost at times: " : "is not seen: ") + mainCause(now, before);
}

RobotTracks::RobotTracks(const TracksOptions& options)
    : options_(options),
      transform_(options.up_axis, options.map_from_mocap),
      tracks_(options.body_from_robot.size(), Track{BodyTracker(options.tracker), {}, 0.0}),
      counts_(options.body_from_robot.size()) {}

std::optional<ReliablePose> RobotTracks::update(const Measurement& measurement, double now_s) {
  TrackCounts& counts = counts_.at(measurement.robot);
  if (!measurement.tracked) {
    ++counts.untracked;
    return std::nullopt;
  }
  const std::optional<Pose> map_from_robot =
      transform_.mapFromRobot(measurement.position_m, measurement.orientation_xyzw,
                              options_.body_from_robot[measurement.robot]);
  if (!map_from_robot) {
    ++counts.malformed;
    return std::nullopt;
  }
  Track& track = tracks_[measurement.robot];
  if (isFrozen(track, measurement, options_.frozen_limit_s)) {
    ++counts.frozen;
    return std::nullopt;
  }
  // Also where it is not a number.
  if (!(measurement.stamp_s > counts.last_stamp_s)) {
    ++counts.unordered;
    return std::nullopt;
  }
  counts.last_age_s = now_s - measurement.stamp_s;
  // Ahead of time is as bad: clocks that differ make every age wrong.
  if (std::abs(counts.last_age_s) > options_.largest_age_s) {
    ++(counts.last_age_s > 0.0 ? counts.stale : counts.ahead);
    return std::nullopt;
  }
  ++counts.good;
  counts.last_stamp_s = measurement.stamp_s;
  return ReliablePose{measurement.robot, measurement.stamp_s, *map_from_robot,
                      track.tracker.update(*map_from_robot, measurement.time_s)};
}

bool RobotTracks::isFrozen(Track& track, const Measurement& measurement, double limit_s) {
  // To the last bit: a body that truly stands still shows the noise of the cameras.
  const bool same = measurement.position_m == track.last.position_m &&
                    measurement.orientation_xyzw == track.last.orientation_xyzw;
  if (!same || measurement.time_s < track.changed_s) {
    track.changed_s = measurement.time_s;
  }
  track.last = measurement;
  return limit_s > 0.0 && measurement.time_s - track.changed_s > limit_s;
}

void RobotTracks::reset() {
  for (Track& track : tracks_) {
    track.tracker.reset();
    track.changed_s = 0.0;
    track.last = {};
  }
  for (TrackCounts& counts : counts_) {
    counts.last_stamp_s = 0.0;
  }
}

}  // namespace sylph_mocap_bridge
