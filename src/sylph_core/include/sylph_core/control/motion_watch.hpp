#pragma once

#include <deque>
#include <optional>
#include <string>

#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// When measured motion counts as another one than the commanded.
struct MotionWatchOptions {
  double window_s = 0.4;      ///< over which motion is compared, > 0
  double aside_m = 0.02;      ///< measured beside all that a base that lags could have moved, > 0
  double least_answer = 0.1;  ///< share of the commanded way that has to be measured, 0 ... 1
  double patience_m = 0.02;   ///< commanded without an answer, before the robot only creeps, > 0
  double creep_mps = 0.02;    ///< speed with which it tries whether its base answers, > 0
  double creep_m = 0.05;      ///< commanded in vain at that speed, before it stops for good, > 0
};

/// Whether a robot moves as it is commanded.
///
/// A pose may be in order and yet be that of another robot, or of a body whose axes are turned:
/// then what is measured has nothing to do with what is commanded, while the robot itself drives
/// on. Over a window, with p the way that the model of the base predicts and m the measured one, a
/// base that is slow, slips or stands has m near the segment from 0 to p. What is more than
/// `aside_m` beside it is a problem at once. A base that does not answer may be stuck for a moment,
/// or be another robot's: after `patience_m` the robot creeps, and after `creep_m` of that it is a
/// problem too.
class MotionWatch {
 public:
  /// @throws std::invalid_argument if an option is out of its bounds
  explicit MotionWatch(const MotionWatchOptions& options);

  /// The motion between two poses, in the map [m], which took `duration_s`.
  void offer(const Vector2& commanded, const Vector2& measured, double duration_s);
  /// The robot is not driven: there is nothing to compare. A problem stays.
  void pause();
  /// The operator has looked: forgets the problem and all motion so far.
  void confirm();

  /// Whether the robot may only creep.
  bool isUnanswered() const { return is_unanswered_; }
  /// Why the robot must not be driven, for the operator; stays until confirm().
  const std::optional<std::string>& problem() const { return problem_; }

 private:
  struct Stretch {
    Vector2 commanded;
    Vector2 measured;
    double duration_s = 0.0;

    void add(const Stretch& other, double sign);
  };

  bool isAnswered(const Stretch& stretch) const;
  void listen(const Stretch& stretch);
  void creep(const Stretch& stretch);

  MotionWatchOptions options_;
  std::deque<Stretch> stretches_;
  Stretch window_;  // their sum
  double unanswered_m_ = 0.0;
  bool is_unanswered_ = false;
  Stretch crept_;
  double creeping_s_ = 0.0;
  std::optional<std::string> problem_;
};

}  // namespace sylph
