#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <string>
#include <vector>

#include "sylph_planner_node/start_cells.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// Hears the poses of robots while they are wanted: motion capture speaks a hundred
/// times a second and robot, a mission asks once.
class PoseListener {
 public:
  PoseListener(ros::NodeHandle nh, const sylph_ros::SteadyClock& clock) : nh_(nh), clock_(clock) {}

  void start(const std::vector<std::string>& robots);
  void stop();

  const MeasuredPoses& poses() const { return poses_; }

 private:
  ros::NodeHandle nh_;
  sylph_ros::SteadyClock clock_;
  std::vector<ros::Subscriber> subscribers_;
  MeasuredPoses poses_;
};

}  // namespace sylph_planner_node
