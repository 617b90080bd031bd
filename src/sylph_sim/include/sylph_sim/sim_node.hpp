#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sylph_msgs/InjectFault.h>

#include <memory>
#include <optional>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_natnet/server.hpp"
#include "sylph_sim/lock_step_host.hpp"
#include "sylph_sim/options.hpp"
#include "sylph_sim/simulation.hpp"
#include "sylph_sim/step_pacer.hpp"

namespace sylph_sim {

/// The simulated lab as a node: takes cmd_vel of every robot, serves NatNet, publishes /clock and
/// the truth. One thread; it steps on a steady wall clock, or in lock step with the lab's nodes.
class SimNode {
 public:
  /// @throws std::runtime_error or std::invalid_argument on a bad parameter or experiment, or if
  /// the port is taken
  SimNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh);

 private:
  void startFreely(ros::NodeHandle& nh);
  void startInLockStep(const ros::NodeHandle& nh);
  void advance(const ros::SteadyTimerEvent& event);
  LockStepHost::Moment advanceTick();
  void step(int count);
  void subscribe(ros::NodeHandle& nh, std::size_t robot);
  void sendFrames(const std::vector<CapturedFrame>& frames);
  void publishClock(double time_s);
  void publishTruth();
  void onCommand(std::size_t robot, const geometry_msgs::Twist& message);
  bool onInjectFault(sylph_msgs::InjectFault::Request& request,
                     sylph_msgs::InjectFault::Response& response);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  Options options_;
  sylph::Experiment experiment_;
  bool is_in_lock_step_;
  double target_speed_;  ///< simulated seconds a wall second; 0: as fast as it goes
  double start_s_;
  Simulation simulation_;
  std::optional<StepPacer> pacer_;
  std::unique_ptr<LockStepHost> lock_step_;
  std::int32_t last_frame_ = 0;  ///< number of the last frame that went to anybody
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
