#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/transform_broadcaster.h>

#include <string>
#include <vector>

#include "sylph_mocap_bridge/rate_gate.hpp"
#include "sylph_mocap_bridge/robot_tracks.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_mocap_bridge {

/// How often each kind of message goes out, by the poses' stamps [Hz]; 0: each frame.
struct PublishRates {
  double pose_hz = 0.0;   ///< `<robot>/pose`
  double odom_hz = 60.0;  ///< `<robot>/odom`
  double tf_hz = 30.0;    ///< `/tf`
};

/// Publishes `<robot>/pose`, `<robot>/odom` and tf `map` -> `<robot>`.
class RobotPublishers {
 public:
  /// @param noise  sigmas of the measured pose, for covariances.
  RobotPublishers(ros::NodeHandle& nh, const sylph_ros::SteadyClock& clock,
                  const std::vector<std::string>& robots, const PublishRates& rates,
                  const TrackerOptions& noise);

  /// @param poses  of one instant
  void publish(const std::vector<ReliablePose>& poses);

 private:
  struct Robot {
    std::string name;
    sylph_ros::Publisher pose;
    ros::Publisher odometry;
    RateGate pose_gate;
    RateGate odometry_gate;
    RateGate tf_gate;
  };

  std::vector<Robot> robots_;
  TrackerOptions noise_;
  tf2_ros::TransformBroadcaster broadcaster_;
};

}  // namespace sylph_mocap_bridge
