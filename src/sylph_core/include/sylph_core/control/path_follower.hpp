#pragma once

#include "sylph_core/control/drive_path.hpp"
#include "sylph_core/control/pid.hpp"
#include "sylph_core/control/pose_predictor.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// Speeds, gains and tolerances of a PathFollower.
struct FollowerOptions {
  double speed_limit_mps = 0.25;          ///< > 0
  double acceleration_limit_mps2 = 0.6;   ///< along the path and in blends, > 0
  double braking_share = 0.95;            ///< of the acceleration that braking plans with, 0 ... 1
  double blend_m = 0.030;                 ///< largest blend distance at corners, >= 0
  double approach_gain = 8.0;             ///< of the distance close to a stop [1/s], > 0
  double lag_s = 0.08;                    ///< time constant of the base, undone by feed-forward
  double heading_rad = 0.0;               ///< held all the time
  double heading_tolerance_rad = 0.0524;  ///< beyond this the robot turns before it drives, > 0
  double tracking_error_m = 0.012;        ///< beyond this it returns to its path first, > 0
  PidGains cross = {3.0, 0.5, 0.0, 0.02, 0.15, 8.0};   ///< across the leg, m -> m/s
  PidGains heading = {2.5, 0.3, 0.0, 0.05, 0.5, 8.0};  ///< rad -> rad/s
};

/// Drives a holonomic robot along a DrivePath with its heading held.
///
/// The speed along the path depends on where the robot is, not on time, so that a robot that is
/// held up or pushed just goes on from there. With d the distance to the next blend or stop, v_c
/// the speed allowed there and b the braking deceleration:
///
///     before a blend   v = min(limit, sqrt(v_c^2 + 2 b d))
///     before a stop    v = min(limit, sqrt(2 b (d - d_1 / 2)))   while d > d_1 = b / gain^2
///                      v = gain d                                from there on, as a vector
///
/// which join smoothly at d_1. Speeding up is limited in time. Feed-forward undoes the lag of the
/// base, u = v + lag dv/dt, also for the bend of the velocity in a blend. Across the path a Pid
/// works on the distance from it, a second one on the heading. A robot that is off its path or its
/// heading by more than the tolerance goes back there first.
class PathFollower {
 public:
  /// @throws std::invalid_argument unless the options are within their bounds
  explicit PathFollower(const FollowerOptions& options);

  /// A new path, from `start`.
  void reset(const Point& start);
  /// Goes on to `waypoint`. If the robot is already closer to the end of its path than the blend
  /// distance, the new corner is rounded less.
  void append(const Point& waypoint);

  /// The velocity to command [map frame].
  ///
  /// @param state  at the time when the command takes effect
  /// @param reached  last waypoint that the robot has reached by measurement: where it stops, it
  ///                 waits for this before the next leg
  /// @param last  waypoint to stop at; one that it cannot stop at any more is passed: firstStop()
  /// @param dt_s  since the last call, > 0
  Twist2d update(const MotionState& state, int reached, int last, double dt_s);

  /// The first waypoint at which the robot can come to rest without leaving the path.
  int firstStop() const;

  /// The robot is stopped for another reason: afterwards it goes on from the speed it then has.
  void halt();

  /// All waypoints since reset(), passed ones included.
  const DrivePath& path() const { return path_; }
  /// Index of the leg that is driven; legCount() at the end.
  int currentLeg() const { return leg_; }

 private:
  /// What the path says about one position.
  struct Guide {
    Vector2 tangent;               // of unit length
    Vector2 correction;            // from the robot to the closest point of the path [m]
    Vector2 bend_mps2;             // change of the velocity in a blend that is driven at v_c
    double scale = 1.0;            // of the speed along the path, below 1 within a blend
    double blend_speed_mps = 0.0;  // v_c; 0 outside blends
    double to_waypoint_m = 0.0;    // along the path to the next waypoint or the end of the blend
  };
  struct SpeedLimit {
    double speed_mps = 0.0;
    double slope_per_s = 0.0;  // its change per distance to go
  };

  bool stopsAt(int waypoint, int last) const;
  void advance(const Point& position, int reached, int last);
  Guide legGuide(const Point& position) const;
  Guide blendGuide(const Point& position) const;
  SpeedLimit speedLimit(const Guide& guide, int last) const;
  SpeedLimit speedBefore(double allowed_mps, double distance_m) const;
  Vector2 along(const Guide& guide, const MotionState& state, int last, double dt_s);
  Vector2 across(const Guide& guide, double dt_s);
  Vector2 approach(const Point& target, const MotionState& state, double dt_s);

  FollowerOptions options_;
  double braking_mps2_;
  double approach_m_;  // d_1: closer to a stop, speed is proportional to distance
  Pid cross_;
  Pid heading_;
  DrivePath path_{Point{}};
  int leg_ = 0;
  double speed_mps_ = 0.0;  // along the path
  double to_waypoint_m_ = 0.0;
  bool is_in_blend_ = false;
  bool is_halted_ = true;
  bool is_at_rest_ = false;
};

}  // namespace sylph
