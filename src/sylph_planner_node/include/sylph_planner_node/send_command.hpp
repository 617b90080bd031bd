#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sylph_msgs/ExecuteMissionGoal.h>
#include <sylph_msgs/JointActions.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_planner_node/pose_listener.hpp"
#include "sylph_planner_node/send_request.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// The command sylph_send: looks where the robots are, judges their goals, and has the mission
/// planned and carried out.
class SendCommand {
 public:
  /// @param nh   in the suite's namespace
  /// @param lab  whose robots are sent
  SendCommand(const ros::NodeHandle& nh, sylph::Experiment lab, SendRequest request);

  /// Sends the mission and follows it. Callbacks of the global queue must be served by another
  /// thread.
  /// @return exit status: 0 all its robots have arrived, or there is a plan where that is all that
  /// is asked for; 1 not
  /// @throws sylph::MissionFailure if a goal cannot be reached
  /// @throws std::runtime_error if planner or poses do not come in time, a mission is under way
  /// that may not be ended, or the experiment file cannot be written
  int run();

 private:
  void waitUntilReady();
  /// @param robots  whose robots have to be seen
  std::optional<std::string> whatIsMissing(const sylph::Experiment& robots) const;
  int showPlan(const sylph_msgs::ExecuteMissionGoal& goal);

  ros::NodeHandle nh_;
  ros::CallbackQueue queue_;  ///< of poses and status, served by run()
  sylph::Experiment lab_;
  SendRequest request_;
  sylph::Experiment participants_;  ///< of the lab, those with part in the mission
  sylph_ros::SteadyClock clock_;
  PoseListener poses_;
  ros::Subscriber status_subscriber_;
  std::optional<actionlib_msgs::GoalStatusArray> status_;  ///< of the planner, the last one
  ros::Subscriber plan_subscriber_;
  sylph_msgs::JointActions plan_;  ///< that is shown
};

}  // namespace sylph_planner_node
