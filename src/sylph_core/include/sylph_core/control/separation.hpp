#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/geometry/circle_grid.hpp"
#include "sylph_core/geometry/footprint.hpp"
#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

/// When robots are too close.
struct SeparationLimits {
  double limit_m = 0.005;               ///< smallest gap between footprints that is right, >= 0
  double command_latency_s = 0.05;      ///< from capture to a moving wheel, >= 0
  double stop_response_s = 0.1;         ///< of a robot's control period and its base's lag, >= 0
  double stop_deceleration_mps2 = 1.0;  ///< of a robot that stops, > 0
  int confirmations = 3;                ///< poses in a row that have to agree, > 0
};

/// How far a robot that is told to stop goes on [m], as the watch reckons: v t + v^2 / 2a, where t
/// is latency and response.
double stoppingDistance(const SeparationLimits& limits, double speed_mps);

/// Two robots, by index, and the gap between their footprints.
struct PairGap {
  int robot_a = -1;  ///< -1: there are no two robots with a pose
  int robot_b = -1;  ///< -1 likewise
  double gap_m;      ///< infinite if there are no two
};

/// Watches the gaps between robots by their measured poses, knowing nothing of plans and tasks.
///
/// Robots are too close if the gap is below the limit, or if their footprints would touch although
/// both were stopped now: after the way v t + v^2 / 2a along their velocities, where t is the
/// latency, the response and the time in which poses confirm it, measured from their stamps. So
/// many poses in a row have to show it that a single bad one stops nobody.
///
/// A pose is compared with those of robots nearby, however many there are.
class SeparationWatch {
 public:
  /// @param sizes  length and width of each robot; where they are does not matter
  SeparationWatch(const std::vector<Footprint>& sizes, const SeparationLimits& limits);

  /// Takes a pose. One that is not finite, or not newer than the last one, is ignored.
  /// @param stamp_s  time of capture [s]
  /// @return whether robots are too close, by this pose and those before it
  bool update(int robot, const Pose2d& pose, double stamp_s);

  /// The closest pair now.
  PairGap closest() const;
  /// The closest pair that there was.
  const PairGap& closestEver() const { return closest_ever_; }
  /// The pair for which update() said last that it is too close.
  const std::optional<PairGap>& violation() const { return violation_; }

 private:
  struct Sample {
    Pose2d pose;
    double stamp_s;
  };
  struct Track {
    Footprint footprint;
    double radius_m = 0.0;   ///< of the circle around the footprint
    Footprint stopped;       ///< where it comes to rest if it stops now
    double reserve_m = 0.0;  ///< how far that is
    std::deque<Sample> samples;
    int too_close_in_a_row = 0;
  };

  static std::size_t index(int robot) { return static_cast<std::size_t>(robot); }
  Footprint whereItStops(const Track& track) const;
  static double lowestGap(const Track& a, const Track& b);

  SeparationLimits limits_;
  std::vector<Track> tracks_;
  CircleGrid reaches_;  ///< of each robot seen: what it covers, and may while it stops
  PairGap closest_ever_;
  std::optional<PairGap> violation_;
};

}  // namespace sylph
