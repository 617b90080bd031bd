#pragma once

#include <optional>
#include <string>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

struct PoseWatchOptions {
  double timeout_s = 0.1;              ///< a pose older than this is stale, > 0
  double speed_limit_mps = 0.25;       ///< of the robot, > 0
  double turn_rate_limit_radps = 0.5;  ///< > 0
  double jump_m = 0.02;  ///< a pose may be so far from where the robot was driven, > 0
  double jump_rad = 0.296705972839036;  ///< the same for the yaw (17 deg), > 0
  double frozen_m = 0.03;     ///< commanded travel during which some digit has to change, > 0
  int good_poses = 3;         ///< in a row, before the pose is trusted again, > 0
  int consistent_poses = 12;  ///< in a row at another place, before that may be believed, > 0
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
  Jumped,     ///< where the robot cannot have been driven
  Recovered,  ///< at another place, and confirmed by the operator: good from now on
};

/// Whether a robot may believe its pose.
///
/// A pose is good if it is finite, newer than the last one, and where the robot was driven since it
/// was seen: at most `jump_m` from where its commands lead it, give or take a tenth of the way;
/// half of that for one that was seen elsewhere meanwhile. So a robot that was stuck just while it
/// was not seen asks for the operator; if all of the way were believed, so would a jump back while
/// it ramps to zero. One that is not good is ignored; several in a row, silence, old stamps, or a
/// pose that does not change by a digit though the robot is told to move make it blind, until good
/// poses return. However long nothing was seen, another place is believed only when the operator
/// confirms it, since a body that is solved wrongly after an occlusion stays wrong.
class PoseWatch {
 public:
  /// @throws std::invalid_argument unless the options are positive
  explicit PoseWatch(const PoseWatchOptions& options);

  /// Takes a pose as it comes.
  /// @param driven  where its commands lead the robot from seen() until the capture of `pose`;
  /// does not matter before the first pose
  PoseVerdict offer(const TimedPose& pose, const Pose2d& driven);

  /// The operator has looked: where the robot is seen now, it is. The next pose there is believed.
  void confirm() { is_confirmed_ = other_place_.has_value(); }

  /// Whether the robot may have been carried since it was believed last: it was out of sight, or
  /// seen on its way. A place that it takes in one step, in sight, is none where it was put.
  bool mayBeCarried() const { return was_unseen_ || moves_ >= kMovesOfCarrying; }

  /// Where the robot is seen that only the operator can confirm: nothing while it is believed, or
  /// seen there in fewer than `consistent_poses`.
  std::optional<Pose2d> placeToConfirm() const;

  /// Tells that the robot was told to move `distance_m` since the last call.
  void commanded(double distance_m);

  /// Why the pose is not to be trusted at `now_s`, for the operator; nothing if it is.
  std::optional<std::string> problem(double now_s) const;

  /// The last good pose.
  const std::optional<TimedPose>& last() const { return last_; }
  /// The last good pose that was not frozen.
  const std::optional<TimedPose>& seen() const { return seen_; }
  /// Its age since capture; infinite without one [s].
  double age(double now_s) const;

 private:
  static constexpr int kMovesOfCarrying = 3;

  void noteWay(const TimedPose& pose);
  /// @param share  of `jump_m` and `jump_rad` that it may be off
  bool canBeAt(const Pose2d& pose, const Pose2d& driven, double share) const;
  bool isSamePlace(const TimedPose& from, const TimedPose& to) const;
  PoseVerdict reject(const TimedPose& pose, bool may_be_true);
  void take(const TimedPose& pose);
  bool looksFrozen(const TimedPose& pose) const;

  PoseWatchOptions options_;
  std::optional<TimedPose> last_;
  std::optional<TimedPose> seen_;
  std::optional<TimedPose> other_place_;
  std::optional<TimedPose> previous_;  // good or not; nothing after one that is not finite
  bool was_unseen_ = false;            // since the last good one
  int moves_ = 0;                      // from one pose to the next, likewise
  int consistent_ = 0;                 // poses in a row at the other place
  bool is_confirmed_ = false;
  int good_ = 0;
  int rejected_ = 0;
  std::string rejection_;
  double unseen_travel_m_ = 0.0;
};

}  // namespace sylph
