#pragma once

#include <optional>
#include <string>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

struct PoseWatchOptions {
  double timeout_s = 0.1;              ///< a pose older than this is stale, > 0
  double speed_limit_mps = 0.25;       ///< of the robot, > 0
  double turn_rate_limit_radps = 0.5;  ///< > 0
  double jump_m = 0.03;                ///< what a pose may be off beyond what the limits allow, > 0
  double jump_rad = 0.296705972839036;  ///< the same for the yaw (17 deg), > 0
  double frozen_m = 0.03;     ///< commanded travel during which some digit has to change, > 0
  int good_poses = 3;         ///< in a row, before the pose is trusted again, > 0
  int consistent_poses = 12;  ///< in a row at another place, before that is believed, > 0
  int rejected_poses = 3;     ///< in a row, before the pose is not trusted any more, > 0
};

/// A pose and when it was true and known. Times count in seconds of the robot's own steady clock,
/// save for the stamp.
struct TimedPose {
  Pose2d pose;
  double stamp_s = 0.0;     ///< of the message, in the clock of the motion capture
  double captured_s = 0.0;  ///< when it was true: received_s less its age
  double received_s = 0.0;  ///< when this computer knew it
};

/// A pose that comes now.
/// @param age_s  since it was true, by clocks of two machines: a little below 0 counts as 0
TimedPose timedPose(const Pose2d& pose, double stamp_s, double age_s, double received_s);

/// What the watch makes of one pose.
enum class PoseVerdict {
  Good,
  Repeated,  ///< stamp not newer than the last one's
  NotFinite,
  Jumped,     ///< farther from the last good one than the robot can be
  Recovered,  ///< at another place, but believed: good from now on
};

/// Whether a robot may believe its pose.
///
/// A pose is good if it is finite, newer than the last one, and as close to it as the robot's
/// limits allow. One that is not is ignored; several in a row, silence, old stamps, or a pose that
/// does not change by a digit though the robot is told to move make it blind, until good poses
/// return. A new place is believed after several poses that agree with each other.
class PoseWatch {
 public:
  /// @throws std::invalid_argument unless the options are positive
  explicit PoseWatch(const PoseWatchOptions& options);

  /// Takes a pose as it comes.
  PoseVerdict offer(const TimedPose& pose);

  /// The operator has looked: where the robot is seen now, it is.
  void confirm() { is_confirmed_ = other_place_.has_value(); }

  /// Tells that the robot was told to move `distance_m` since the last call.
  void commanded(double distance_m);

  /// Why the pose is not to be trusted at `now_s`, for the operator; nothing if it is.
  std::optional<std::string> problem(double now_s) const;

  /// The last good pose.
  const std::optional<TimedPose>& last() const { return last_; }
  /// Its age since capture; infinite without one [s].
  double age(double now_s) const;

 private:
  bool agrees(const TimedPose& from, const TimedPose& to) const;
  PoseVerdict reject(const TimedPose& pose, bool is_same_place, bool may_be_true);
  void take(const TimedPose& pose);
  bool looksFrozen(const TimedPose& pose) const;

  PoseWatchOptions options_;
  std::optional<TimedPose> last_;
  std::optional<TimedPose> other_place_;
  int consistent_ = 0;        // poses in a row at the other place
  bool may_be_true_ = false;  // the robot was unseen before it showed up there
  bool is_confirmed_ = false;
  double last_seen_s_ = 0.0;  // receipt of the last pose that was finite and not frozen
  int good_ = 0;
  int rejected_ = 0;
  std::string rejection_;
  double unseen_travel_m_ = 0.0;
};

}  // namespace sylph
