#pragma once

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// How fast and how far slip is learned.
struct SlipOptions {
  double largest = 0.1;       ///< share of the speed that may be made up for, 0 ... 0.5
  double memory_m = 0.3;      ///< way over which the estimate is averaged, > 0
  double slowest_mps = 0.08;  ///< slower motion tells nothing, > 0
};

/// What share of the commanded speed the base loses, for each axis of the robot: mecanum wheels
/// slip, sideways more than forwards.
///
/// With p the way that the model of the base predicts without slip and m the measured one, along an
/// axis, the gain g = m / p is averaged over the way:
///
///     g <- g + (m - g p) / memory
///
/// and kept within 1 - largest ... 1. A command divided by g moves the base as wanted.
class SlipEstimator {
 public:
  /// @throws std::invalid_argument if an option is out of its bounds
  explicit SlipEstimator(const SlipOptions& options);

  /// Learns from one stretch of motion along the axes of the robot [m] that took `duration_s`.
  void learn(const Vector2& predicted, const Vector2& measured, double duration_s);

  /// The command that moves the base with `wanted_robot`.
  Twist2d compensate(const Twist2d& wanted_robot) const;

  /// Measured over predicted way along the robot's x axis.
  double forwardGain() const { return forward_; }
  /// The same along its y axis.
  double sidewaysGain() const { return sideways_; }

 private:
  void learnAxis(double& gain, double predicted_m, double measured_m, double duration_s) const;

  SlipOptions options_;
  double forward_ = 1.0;
  double sideways_ = 1.0;
};

}  // namespace sylph
