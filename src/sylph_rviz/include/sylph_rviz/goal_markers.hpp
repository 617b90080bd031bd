#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <ros/node_handle.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "sylph_rviz/goal_handle.hpp"

namespace sylph_rviz {

/// Robots to click and goals to drag in RViz: its interactive markers, see kGoalMarkersTopic.
class GoalMarkers {
 public:
  /// @param suite_nh  in the suite's namespace
  explicit GoalMarkers(const ros::NodeHandle& suite_nh);

  /// What the operator has done since the last call.
  std::vector<GoalEvent> takeEvents();

  /// Brings what RViz shows up to date. A handle that is being dragged stays in the operator's
  /// hand.
  /// @param cell_size_m  handles are as large as a cell, > 0
  void show(const std::vector<GoalHandle>& handles, double cell_size_m);

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void onFeedback(const Feedback& feedback, const std::string& robot);
  void showRobot(const GoalHandle& handle);
  void showGoal(const GoalHandle& handle, double cell_size_m);

  std::mutex mutex_;  ///< of events and what is held, and never locked while the server is called
  std::vector<GoalEvent> events_;
  std::string held_;      ///< the robot on whose handle the mouse button is down; empty: none
  sylph::Point held_at_;  ///< where it is
  std::map<std::string, GoalHandle> shown_;
  std::string dragged_;  ///< the robot whose handle is in the operator's hand; empty: none
  std::vector<std::string> dropped_;  ///< whose handles RViz shows where they were let go
  interactive_markers::InteractiveMarkerServer server_;  ///< last: its thread calls onFeedback()
};

}  // namespace sylph_rviz
