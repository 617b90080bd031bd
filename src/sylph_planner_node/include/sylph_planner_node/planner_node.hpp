#pragma once

#include <actionlib/server/simple_action_server.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/ExecuteMissionAction.h>
#include <sylph_msgs/JointActions.h>

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_planner_node/checked_plan.hpp"
#include "sylph_planner_node/mission.hpp"
#include "sylph_planner_node/mode_caller.hpp"
#include "sylph_planner_node/options.hpp"
#include "sylph_planner_node/pose_listener.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// Takes a mission, plans it in a thread of its own, checks the plan, sends it to the central node
/// and follows its execution; plans the rest when robots are lost.
///
/// All callbacks run in one thread. A mission passes through the stages below, moved on by tick().
class PlannerNode {
 public:
  /// @throws std::runtime_error on a bad parameter, experiment or weight file
  PlannerNode(ros::NodeHandle nh, ros::NodeHandle private_nh);

 private:
  enum class Stage {
    Idle,
    Starting,   ///< waits for poses, for the central node, for robots to hold
    Planning,   ///< the thread is at work
    Sending,    ///< the central node does not carry the plan out yet
    Executing,  ///< follows AdgState
    Pausing,    ///< cancelled: waits for the robots to hold
  };

  using Server = actionlib::SimpleActionServer<sylph_msgs::ExecuteMissionAction>;

  void onGoal();
  void onPreempt();
  void onAdgState(const sylph_msgs::AdgState& state);
  void publishMap();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  void tick();
  void tickStarting();
  void tickPlanning();
  void tickSending();
  void tickExecuting();
  void tickPausing();

  void startPlanning();
  void startReplanning();
  void send(const CheckedPlan& plan);
  void publishPlan();
  /// Takes the plan back, so that no central node that starts later finds it.
  void withdrawPlan();
  void follow();
  void publishFeedback();

  void enter(Stage stage);
  /// Fails the mission unless the central node has been heard of recently enough.
  bool isCentralHeard();
  /// Ends the mission with the failure's outcome.
  void fail(const MissionFailure& failure);
  void finish(sylph_msgs::ExecuteMissionResult result);
  /// Leaves a mission half-way: robots that are under way hold at their next cells.
  void abandon();
  bool isPlanningThreadBusy() const;
  bool isPreviousMissionMoving() const;

  ros::NodeHandle nh_;
  Options options_;
  sylph::Experiment lab_;
  Weights weights_;
  sylph_ros::SteadyClock clock_;
  PoseListener poses_;
  ModeCaller mode_;

  Stage stage_ = Stage::Idle;
  double stage_since_s_ = 0.0;  ///< steady time [s]
  Mission mission_;
  std::vector<std::string> planned_robots_;  ///< of the plan that is made, sent or carried out
  std::uint32_t plan_id_ = 0;
  std::uint32_t replaces_plan_id_ = 0;
  std::uint32_t replans_ = 0;
  std::vector<std::string> given_up_;
  sylph_msgs::ExecuteMissionResult totals_;  ///< plan_steps, sum_of_costs and planning_s so far
  std::future<CheckedPlan> planning_;
  std::optional<sylph_msgs::JointActions> plan_;  ///< that stands on the topic
  double sent_s_ = 0.0;                           ///< steady time [s]
  std::optional<sylph_msgs::AdgState> state_;     ///< the last one
  double state_received_s_ = 0.0;                 ///< steady time [s]
  double feedback_sent_s_ = 0.0;                  ///< steady time [s]
  std::string last_outcome_ = "no mission yet";

  ros::Publisher joint_actions_publisher_;
  ros::Publisher map_publisher_;
  ros::Subscriber adg_state_subscriber_;
  Server server_;
  diagnostic_updater::Updater diagnostics_;
  ros::SteadyTimer map_timer_;
  ros::SteadyTimer tick_timer_;
};

}  // namespace sylph_planner_node
