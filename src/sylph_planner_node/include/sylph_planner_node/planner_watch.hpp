#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

namespace sylph_planner_node {

/// Whether the planner that a goal was sent to still lives: an action server publishes its status
/// all the time. Callbacks must be served by another thread.
class PlannerWatch {
 public:
  /// @param nh       with the global callback queue
  /// @param action   its name, relative to `nh`
  /// @param limit_s  wall time without a status that is too long
  /// @param rest     how the message ends, with what the operator has to expect
  PlannerWatch(const ros::NodeHandle& nh, const std::string& action, double limit_s,
               std::string rest = "");

  /// @param is_connected  whether the action has a server, as its client knows
  /// @throws std::runtime_error if no status has come for too long: the planner is gone, or hangs
  void requireAlive(bool is_connected) const;

 private:
  using Clock = std::chrono::steady_clock;

  std::string action_;
  std::chrono::duration<double> limit_;
  std::string rest_;
  /// A callback may outlive this.
  std::shared_ptr<std::atomic<Clock::time_point>> heard_;
  ros::Subscriber subscriber_;
};

}  // namespace sylph_planner_node
