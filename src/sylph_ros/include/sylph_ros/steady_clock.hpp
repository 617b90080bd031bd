#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>

namespace sylph_ros {

/// Time for watchdogs and control: steady, never ROS time, so that neither a paused simulation nor
/// a clock that is set stops them. In simulation it runs `speed` times faster than the wall, so
/// that limits keep their meaning.
class SteadyClock {
 public:
  /// @param speed  simulated seconds per second, > 0; 1 on real robots
  explicit SteadyClock(double speed = 1.0);

  /// From the parameter kSpeedParameter; without it, as on real robots, 1.
  /// @param suite_nh  in the suite's namespace
  /// @throws std::runtime_error if it is not a positive number
  static SteadyClock fromParameter(const ros::NodeHandle& suite_nh);

  /// Seconds since some fixed moment, in simulated seconds.
  double now() const { return ros::SteadyTime::now().toSec() * speed_; }

  /// How long the wall takes for `simulated_s` seconds, for timers.
  ros::WallDuration wall(double simulated_s) const {
    return ros::WallDuration(simulated_s / speed_);
  }

  double speed() const { return speed_; }

 private:
  double speed_;
};

}  // namespace sylph_ros
