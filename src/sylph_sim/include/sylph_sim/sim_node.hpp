#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sylph_msgs/InjectFault.h>

#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_natnet/server.hpp"
#include "sylph_ros/steady_clock.hpp"
#include "sylph_sim/options.hpp"
#include "sylph_sim/simulation.hpp"
#include "sylph_sim/step_pacer.hpp"

namespace sylph_sim {

/// The simulated lab as a node: takes cmd_vel of every robot, serves NatNet, publishes /clock and
/// the truth. One thread; it steps on a steady wall clock.
class SimNode {
 public:
  /// @throws std::runtime_error or std::invalid_argument on a bad parameter or experiment, or if
  /// the port is taken
  SimNode(ros::NodeHandle nh, ros::NodeHandle private_nh);

 private:
  void advance(const ros::SteadyTimerEvent& event);
  void sendFrames(const std::vector<CapturedFrame>& frames);
  void publishClock();
  void publishTruth();
  void onCommand(std::size_t robot, const geometry_msgs::Twist& message);
  bool onInjectFault(sylph_msgs::InjectFault::Request& request,
                     sylph_msgs::InjectFault::Response& response);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  Options options_;
  sylph::Experiment experiment_;
  sylph_ros::SteadyClock clock_;
  double start_s_;
  Simulation simulation_;
  StepPacer pacer_;
  sylph_natnet::Server server_;
  double clock_period_s_;
  double next_clock_s_;
  double next_truth_s_;
  ros::Publisher clock_publisher_;
  ros::Publisher truth_publisher_;
  std::vector<ros::Subscriber> command_subscribers_;
  ros::ServiceServer inject_fault_server_;
  diagnostic_updater::Updater diagnostics_;
  ros::SteadyTimer timer_;
};

}  // namespace sylph_sim
