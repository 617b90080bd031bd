#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_mocap_bridge/body_tracker.hpp"
#include "sylph_mocap_bridge/frame_transform.hpp"

namespace sylph_mocap_bridge {

/// Axes, calibration, and what makes a pose one to rely on.
struct TracksOptions {
  UpAxis up_axis = UpAxis::Z;                  ///< of the cameras
  sylph::Pose2d map_from_mocap;                ///< where the cameras' origin lies on the map
  std::vector<sylph::Pose2d> body_from_robot;  ///< of each robot
  double largest_age_s = 0.5;  ///< an older pose is stale, one of the future no pose, > 0
  /// A pose that keeps each of its bits for longer is frozen: cameras have noise, >= 0, 0: never.
  double frozen_limit_s = 0.1;
  TrackerOptions tracker;  ///< for velocities
};

/// A pose as it came from the cameras.
struct Measurement {
  std::size_t robot = 0;                                 ///< index in the experiment
  bool tracked = true;                                   ///< the cameras saw it in this frame
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the cameras' axes
  Eigen::Vector4d orientation_xyzw{0.0, 0.0, 0.0, 1.0};  ///< in the cameras' axes
  double time_s = 0.0;                                   ///< of the exposure, by the cameras' clock
  double stamp_s = 0.0;                                  ///< of the exposure, by the local clock
};

/// A pose to rely on, as it is published.
struct ReliablePose {
  std::size_t robot = 0;
  double stamp_s = 0.0;
  Pose map_from_robot;               ///< rotation and position in `map`
  std::optional<Velocity> velocity;  ///< nothing until enough poses have come
};

/// What became of a robot's measurements since the start.
struct TrackCounts {
  std::uint64_t good = 0;       ///< passed on
  std::uint64_t untracked = 0;  ///< not seen by the cameras
  std::uint64_t malformed = 0;  ///< not finite, or no rotation
  std::uint64_t stale = 0;      ///< too old
  std::uint64_t ahead = 0;      ///< of the future by as much
  std::uint64_t frozen = 0;     ///< the same for too long
  std::uint64_t unordered = 0;  ///< not newer than the one before
  double last_stamp_s = 0.0;    ///< of the last good one
  double last_age_s = 0.0;      ///< of the last one that was ordered, when it came; < 0: ahead
};

/// What is wrong with a robot's body, from the counts of now and of a while ago.
/// @return empty if nothing is
std::string bodyProblem(const TrackCounts& now, const TrackCounts& before);
/// Share of good measurements between the two, 0 ... 1; 0 if there were none.
double goodRatio(const TrackCounts& now, const TrackCounts& before);

/// Turns measurements into poses in the map and lets no bad one through.
class RobotTracks {
 public:
  explicit RobotTracks(const TracksOptions& options);

  /// @param now_s  local clock
  /// @return nothing if the measurement is not to be relied on
  std::optional<ReliablePose> update(const Measurement& measurement, double now_s);

  /// The clocks began anew: earlier stamps and velocities mean nothing.
  void reset();

  /// One a robot.
  const std::vector<TrackCounts>& counts() const { return counts_; }

 private:
  struct Track {
    BodyTracker tracker;
    Measurement last;        ///< as the cameras told it
    double changed_s = 0.0;  ///< when its pose was last another than before, by the cameras' clock
  };

  static bool isFrozen(Track& track, const Measurement& measurement, double limit_s);

  TracksOptions options_;
  FrameTransform transform_;
  std::vector<Track> tracks_;
  std::vector<TrackCounts> counts_;
};

}  // namespace sylph_mocap_bridge
