#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/mission/start_cells.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// Hears the poses of robots while they are wanted: motion capture speaks a hundred
/// times a second and robot, a mission asks once.
class PoseListener {
 public:
  PoseListener(const ros::NodeHandle& nh, sylph_ros::SteadyClock clock)
      : nh_(nh), clock_(std::move(clock)) {}

  /// Subscribes to the poses of these robots, forgetting others.
  void start(const std::vector<std::string>& robots);
  /// Unsubscribes; judged() keeps what was heard.
  void stop();

  /// The last pose of each robot that has been heard.
  /// @param timeout_s  a pose that came earlier is faulty [s]
  sylph::RobotPoses judged(double timeout_s) const;

 private:
  struct MeasuredPose {
    geometry_msgs::PoseStamped pose;
    double received_s = 0.0;  ///< steady time [s]
  };

  ros::NodeHandle nh_;
  sylph_ros::SteadyClock clock_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, MeasuredPose> poses_;
};

}  // namespace sylph_planner_node
