#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <future>
#include <mutex>
#include <string>

namespace sylph_rviz {

/// One std_srvs/Trigger service, called without waiting for its answer.
class TriggerCall {
 public:
  /// @param name  of the service, relative to `nh`; also what messages call it
  /// @param timeout_s  wall time after which a call is given up [s]
  TriggerCall(const ros::NodeHandle& nh, std::string name, double timeout_s);
  /// Gives up a call that is under way.
  ~TriggerCall();
  TriggerCall(const TriggerCall&) = delete;
  TriggerCall& operator=(const TriggerCall&) = delete;

  /// Begins a call, unless one is under way.
  void call();

  /// Gives up a call that has taken too long.
  /// @return how the last call ended, in one line, once; empty while there is nothing to tell
  std::string takeOutcome();

 private:
  std::string callService();
  void giveUp();

  ros::NodeHandle nh_;
  std::string name_;
  double timeout_s_;
  ros::SteadyTime begun_;
  std::future<std::string> answer_;
  std::mutex mutex_;
  ros::ServiceClient client_;  ///< of the call under way
  bool is_given_up_ = false;
};

}  // namespace sylph_rviz
