#pragma once

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>
#include <sylph_msgs/ExecuteMissionActionFeedback.h>
#include <sylph_msgs/ExecuteMissionActionGoal.h>
#include <sylph_msgs/ExecuteMissionActionResult.h>

#include <atomic>
#include <string>

namespace sylph_planner_node {

/// A planner that hangs as soon as it has a goal: from then on it gives no status. The test's
/// spinner serves it.
class FakePlanner {
 public:
  explicit FakePlanner(const std::string& action)
      : nh_(action),
        goal_subscriber_(nh_.subscribe("goal", 1, &FakePlanner::onGoal, this)),
        cancel_subscriber_(nh_.subscribe("cancel", 1, &FakePlanner::onCancel, this)),
        status_publisher_(nh_.advertise<actionlib_msgs::GoalStatusArray>("status", 1)),
        feedback_publisher_(nh_.advertise<sylph_msgs::ExecuteMissionActionFeedback>("feedback", 1)),
        result_publisher_(nh_.advertise<sylph_msgs::ExecuteMissionActionResult>("result", 1)),
        timer_(nh_.createWallTimer(ros::WallDuration(0.05), &FakePlanner::giveStatus, this)) {}

  bool hasGoal() const { return has_goal_; }

 private:
  void onGoal(const sylph_msgs::ExecuteMissionActionGoal& /*goal*/) { has_goal_ = true; }
  void onCancel(const actionlib_msgs::GoalID& /*goal*/) {}

  void giveStatus(const ros::WallTimerEvent& /*event*/) {
    if (!has_goal_) {
      status_publisher_.publish(actionlib_msgs::GoalStatusArray());
    }
  }

  std::atomic<bool> has_goal_{false};
  ros::NodeHandle nh_;
  ros::Subscriber goal_subscriber_;
  ros::Subscriber cancel_subscriber_;
  ros::Publisher status_publisher_;
  ros::Publisher feedback_publisher_;
  ros::Publisher result_publisher_;
  ros::WallTimer timer_;
};

}  // namespace sylph_planner_node
