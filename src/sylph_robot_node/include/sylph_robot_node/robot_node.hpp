#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/Task.h>

#include <optional>

#include "sylph_core/control/robot_controller.hpp"
#include "sylph_core/control/robot_reporter.hpp"
#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_robot_node/options.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_robot_node {

/// Connects a sylph::RobotController with ROS: topics in, topics out, at 50 Hz of steady time.
class RobotNode {
 public:
  /// @throws std::runtime_error on a bad parameter or experiment
  RobotNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  void onTask(const sylph_msgs::Task& message);
  void onPose(const geometry_msgs::PoseStamped& message);
  void onAdgState(const sylph_msgs::AdgState& message);
  void onEmergencyStop(const std_msgs::Bool& message);
  bool onConfirmPose(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void onTick();
  void goDownWithoutSimulator();
  void goDown(double now_s);
  void report(double now_s);  ///< if it is time for it
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  Options options_;
  sylph_ros::SteadyClock clock_;
  sylph::CellFrame frame_;
  sylph::RobotController controller_;
  sylph::RobotReporter reporter_;
  ros::NodeHandle nh_;
  sylph_ros::Publisher command_publisher_;
  sylph_ros::Publisher report_publisher_;
  ros::Subscriber task_subscriber_;
  ros::Subscriber pose_subscriber_;
  ros::Subscriber adg_state_subscriber_;
  ros::Subscriber emergency_subscriber_;
  ros::ServiceServer confirm_pose_server_;
  diagnostic_updater::Updater updater_;
  sylph_ros::Timer timer_;
  ros::SteadyTimer shutdown_timer_;  // where timer_ waits for a simulator that is gone
  double largest_tick_s_ = 0.0;      // of the time between two ticks, since the last diagnosis
  std::optional<double> ticked_s_;
  std::optional<double> shutdown_since_s_;
};

}  // namespace sylph_robot_node
