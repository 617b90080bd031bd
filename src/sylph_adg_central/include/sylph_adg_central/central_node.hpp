#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <sylph_msgs/DeclareLost.h>
#include <sylph_msgs/ExecuteMissionActionResult.h>
#include <sylph_msgs/JointActions.h>
#include <sylph_msgs/SeparationState.h>
#include <sylph_msgs/SimulationTruth.h>
#include <sylph_msgs/TaskReport.h>

#include <string>
#include <vector>

#include "sylph_adg_central/condition_log.hpp"
#include "sylph_adg_central/event_log.hpp"
#include "sylph_adg_central/options.hpp"
#include "sylph_adg_central/run_folder.hpp"
#include "sylph_core/adg/execution.hpp"
#include "sylph_core/adg/run_record.hpp"
#include "sylph_core/control/safety_margin.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_adg_central {

/// Takes plans and hands tasks out to the robots. What to do is decided by
/// sylph::Execution; this class carries messages, the clock and the event log to it and back.
class CentralNode {
 public:
  /// @throws std::runtime_error on a bad parameter, experiment or event log, and if the experiment
  /// leaves no safety margin
  CentralNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  ~CentralNode();
  CentralNode(const CentralNode&) = delete;
  CentralNode& operator=(const CentralNode&) = delete;

 private:
  struct Follow;  ///< what each event is followed by here

  void subscribe();
  template <typename Message>
  void subscribe(const std::string& topic, std::uint32_t queue_size,
                 void (CentralNode::*handle)(const Message&));
  void advertiseServices();
  void rebuild();

  void onJointActions(const sylph_msgs::JointActions& message);
  void onReport(int robot, const sylph_msgs::TaskReport& message);
  void onSeparation(const sylph_msgs::SeparationState& message);
  void onEmergencyStop(const std_msgs::Bool& message);
  void onTruth(const sylph_msgs::SimulationTruth& message);
  void onMissionResult(const sylph_msgs::ExecuteMissionActionResult& message);
  bool onDeclareLost(sylph_msgs::DeclareLost::Request& request,
                     sylph_msgs::DeclareLost::Response& response);
  bool setMode(sylph::ExecutionMode mode, std_srvs::Trigger::Response& response);
  void onTimer();

  /// Logs what has happened, then sends what follows from it.
  void flush();
  void publishState();
  void saveResult();
  /// Says in what condition a robot is that a mission needs.
  void logCondition(int robot, sylph::RobotCondition condition, const std::string& reason);
  /// Hands out no more tasks, since what happens can no longer be written down: a node that is
  /// started again would not know of it.
  void breakOff(const std::string& reason);
  void reportDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  sylph_ros::SteadyClock clock_;
  sylph::Experiment experiment_;
  sylph::SafetyMargin margin_;
  CentralOptions options_;
  sylph::CellFrame frame_;
  std::vector<std::string> names_;
  bool is_restart_;  ///< of this node, within the same run
  RunFolder folder_;
  EventLog log_;
  sylph::Execution execution_;
  sylph::RunRecord record_;
  ConditionLog condition_log_;
  std::string notice_;  ///< to be told while nothing else is
  std::string broken_;  ///< why the mission was broken off; empty: it was not
  std::uint32_t broken_plan_id_ = 0;
  std::string emergency_reason_ = "the separation monitor stops all robots";
  bool has_changed_ = true;     ///< since the last AdgState
  double state_sent_s_ = 0.0;   ///< steady time
  bool is_result_due_ = false;  ///< a mission has begun that has no result yet

  std::vector<sylph_ros::Publisher> task_publishers_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  sylph_ros::Publisher state_publisher_;
  sylph_ros::Timer timer_;
  diagnostic_updater::Updater diagnostics_;
};

}  // namespace sylph_adg_central
