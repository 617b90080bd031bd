#pragma once

#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <std_srvs/Trigger.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/JointActions.h>

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_core/mission/mission.hpp"

namespace sylph_planner_node {

/// Stands for the central node, the robots and the motion capture: a plan that has arrived whole is
/// carried out one step a tick, and the poses follow.
class MockCentral {
 public:
  /// The robots of a mission in their cells, no plan known.
  MockCentral(const sylph::Mission& mission, const sylph::Configuration& starts);

  // How it behaves from now on.
  void dropOnePlan();
  void refusePlans(const std::string& reason);
  void silencePoseOf(const std::string& robot);
  void beSilent();
  /// Steps that are carried out before it stops by itself.
  void haltAfter(std::uint32_t steps);
  /// Takes a robot out: the others go to the cut, which is where they are.
  void lose(const std::string& name);
  /// As if a plan had been received from another planner and were being carried out.
  void pretendToExecute(std::uint32_t plan_id, const sylph::Configuration& goals);
  void finish();
  void setPlanId(std::uint32_t plan_id);

  /// Returns when its present state has been published three times since the call.
  bool waitForStatesOnTheirWay() const;

  // What it has seen.
  sylph_msgs::AdgState state() const;
  std::vector<sylph_msgs::JointActions> received() const;
  /// The last plan that has arrived.
  sylph::Plan plan() const;

 private:
  void onJointActions(const sylph_msgs::JointActions& message);
  bool onPause(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onResume(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void tick();
  void advance();
  void publish();
  sylph_msgs::RobotExecution& robot(const std::string& name);

  mutable std::mutex mutex_;
  ros::NodeHandle nh_{"/sylph"};
  sylph::Mission mission_;
  sylph_msgs::AdgState state_;
  sylph::MissionPlan plan_;                         ///< state_.plan_id
  std::vector<sylph_msgs::JointActions> received_;  ///< plans, not their withdrawals
  std::set<std::string> without_pose_;
  std::string refusal_;
  std::uint32_t next_step_ = 0;
  std::uint32_t halt_after_ = 1000000;
  bool drops_ = false;
  bool is_silent_ = false;
  std::uint32_t published_ = 0;

  ros::Publisher state_publisher_;
  std::map<std::string, ros::Publisher> pose_publishers_;
  ros::Subscriber subscriber_;
  ros::ServiceServer pause_server_;
  ros::ServiceServer resume_server_;
  ros::SteadyTimer timer_;
};

}  // namespace sylph_planner_node
