#include "sylph_mocap_bridge/robot_tracks.hpp"

namespace sylph_mocap_bridge {

RobotTracks::RobotTracks(const TracksOptions& options)
    : options_(options),
      transform_(options.up_axis, options.map_from_mocap),
      trackers_(options.body_from_robot.size(), BodyTracker(options.tracker)),
      counts_(options.body_from_robot.size()) {}

std::optional<RobotState> RobotTracks::update(const Measurement& measurement, double now_s) {
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
  if (!(measurement.stamp_s > counts.last_stamp_s)) {
    ++counts.unordered;
    return std::nullopt;
  }
  if (now_s - measurement.stamp_s > options_.largest_age_s) {
    ++counts.stale;
    return std::nullopt;
  }
  ++counts.good;
  counts.last_stamp_s = measurement.stamp_s;
  counts.last_age_s = now_s - measurement.stamp_s;
  return RobotState{measurement.robot, measurement.stamp_s, *map_from_robot,
                    trackers_[measurement.robot].update(*map_from_robot, measurement.time_s)};
}

void RobotTracks::reset() {
  for (BodyTracker& tracker : trackers_) {
    tracker.reset();
  }
  for (TrackCounts& counts : counts_) {
    counts.last_stamp_s = 0.0;
  }
}

}  // namespace sylph_mocap_bridge
