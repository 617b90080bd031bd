#pragma once

#include <actionlib/server/simple_action_server.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/ExecuteMissionAction.h>
#include <sylph_msgs/JointActions.h>

#include <future>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/mission/mission_lifecycle.hpp"
#include "sylph_planner_node/mission_request.hpp"
#include "sylph_planner_node/mode_caller.hpp"
#include "sylph_planner_node/options.hpp"
#include "sylph_planner_node/plan_server.hpp"
#include "sylph_planner_node/pose_listener.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// Takes missions as an action server and tells a sylph::MissionLifecycle what happens; does what
/// that one wants to be done. Plans are made in a thread of their own.
///
/// All callbacks run in one thread.
class PlannerNode {
 public:
  /// @throws std::runtime_error on a bad parameter, experiment or weight file
  PlannerNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  using Server = actionlib::SimpleActionServer<sylph_msgs::ExecuteMissionAction>;

  void onGoal();
  void onPreempt();
  void onAdgState(const sylph_msgs::AdgState& message);
  void tick();
  void publishMap();
  void publishFeedback();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  void carryOutCommands();
  void carryOut(const sylph::mission_command::Plan& command);
  void carryOut(const sylph::mission_command::Publish& command);
  void carryOut(const sylph::mission_command::PublishAgain& command);
  void carryOut(const sylph::mission_command::Withdraw& command);
  void carryOut(const sylph::mission_command::Pause& /*command*/) { mode_.pause(); }
  void carryOut(const sylph::mission_command::Resume& /*command*/) { mode_.resume(); }
  static void carryOut(const sylph::mission_command::Say& command);
  void carryOut(const sylph::mission_command::End& command);

  ros::NodeHandle nh_;
  Options options_;
  sylph::Experiment lab_;
  Weights weights_;
  sylph_ros::SteadyClock clock_;
  PoseListener poses_;
  ModeCaller mode_;
  sylph::MissionLifecycle lifecycle_;

  std::future<sylph::PlanningOutcome> planning_;
  sylph_msgs::JointActions plan_;  ///< that stands on the topic
  nav_msgs::OccupancyGrid map_;
  double feedback_sent_s_ = 0.0;  ///< steady time [s]

  sylph_ros::Publisher joint_actions_publisher_;
  ros::Publisher map_publisher_;
  ros::Subscriber adg_state_subscriber_;
  Server server_;
  PlanServer plan_server_;
  diagnostic_updater::Updater diagnostics_;
  sylph_ros::Timer map_timer_;
  sylph_ros::Timer tick_timer_;
};

}  // namespace sylph_planner_node
