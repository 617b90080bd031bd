#pragma once

#include <string>
#include <vector>

namespace sylph {

/// What decides whether two robots in neighbouring cells can touch.
struct SafetyFactors {
  double length_m = 0.0;                 ///< footprint of the larger of two robots, > 0
  double width_m = 0.0;                  ///< > 0
  double cell_size_m = 0.0;              ///< > 0
  double heading_tolerance_rad = 0.0;    ///< largest deviation from the common heading, >= 0
  double tracking_error_m = 0.0;         ///< largest distance from the planned segment, >= 0
  double position_tolerance_m = 0.0;     ///< a task is DONE within this distance of its end, >= 0
  double speed_limit_mps = 0.0;          ///< > 0
  double acceleration_limit_mps2 = 0.0;  ///< also for braking, > 0
  double pose_timeout_s = 0.0;           ///< a robot drives on so long without a pose, >= 0
  double base_timeout_s = 0.0;           ///< a base drives on so long without a command, >= 0
  double command_latency_s = 0.0;        ///< from capture to a moving wheel, >= 0
};

/// What the margin says of a configuration.
enum class SafetyVerdict {
  Run,       ///< robots stay apart, even if one loses its pose or its node at the worst moment
  SlowDown,  ///< they stay apart as long as poses come; slower, also without
  Refuse,    ///< they may touch although everybody keeps to its tolerances
};

/// How far apart the footprints of two robots stay that hold different cells.
///
/// Robots hold the start and end cell of each task until it is done, so that the centres of any two
/// planned segments stay one cell apart. Towards a neighbour a footprint that is turned by up to
/// theta reaches
///     reach = max over t <= theta of L/2 cos t + W/2 sin t  (or with L and W swapped),
/// and two robots that are both off by e = max(tracking error, position tolerance) keep
///     separation = cell - 2 reach - 2 e.
/// A robot that loses its pose where it should begin to brake, or whose node falls silent there,
/// goes v (max(pose timeout, base timeout) + latency) too far, since the way that it needs for
/// braking lies within the cells that it holds. Being ahead on its segment, and not beside it, its
/// own e does not add to that:
///     blind separation = cell - 2 reach - e - overrun.
struct SafetyMargin {
  double reach_m = 0.0;  ///< of a footprint towards its neighbour, turned by up to the tolerance
  double error_m = 0.0;  ///< larger of tracking error and position tolerance
  double blind_travel_m = 0.0;      ///< from the last good pose or command to a standstill
  double overrun_m = 0.0;           ///< of that, beyond the cells that the robot holds
  double separation_m = 0.0;        ///< gap between footprints while all robots have poses
  double blind_separation_m = 0.0;  ///< gap if one robot loses pose or node at the worst moment
  SafetyVerdict verdict = SafetyVerdict::Refuse;
  std::vector<std::string> remedies;  ///< each alone would do; empty where nothing is needed

  /// The gap that holds in either case [m].
  double promisedSeparation() const;
  /// One line with the figures in millimetres.
  std::string summary() const;
};

/// Bounds of the factors are for the caller to keep; factors that leave no gap give Refuse.
SafetyMargin computeSafetyMargin(const SafetyFactors& factors);

}  // namespace sylph
