#pragma once

#include <actionlib/client/simple_action_client.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/node_handle.h>
#include <sylph_msgs/ExecuteMissionAction.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_ros/capture_findings.hpp"
#include "sylph_ros/parameter_reader.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_planner_node {

/// Parameters of sylph_mission besides those of sylph_ros::loadExperiment().
struct ClientOptions {
  bool exit_when_done = true;     ///< false: keeps running after the result, so that the rest stays
  double start_timeout_s = 60.0;  ///< wall time for action server and poses to appear and for the
                                  ///< server's silence; without poses the planner is asked all
                                  ///< the same
  double progress_period_s = 2.0;  ///< wall time between progress lines when nothing changes
  double report_wait_s = 5.0;      ///< wall time for result.yaml to be written
};

/// Meaning and bounds of each.
/// @throws std::runtime_error on a mistyped or forbidden value
ClientOptions readClientOptions(sylph_ros::ParameterReader& reader);

/// Sends a mission, tells the operator how it goes and how it ended.
class MissionClient {
 public:
  /// The mission of the lab's experiment, which begins with it.
  /// @throws std::runtime_error on a bad parameter, experiment or weight file
  MissionClient(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  /// A mission for a lab that runs.
  /// @param headline  what it is, the first thing that is said
  MissionClient(const ros::NodeHandle& nh, const ClientOptions& options, sylph::Experiment lab,
                sylph_msgs::ExecuteMissionGoal mission, std::string headline);

  /// Runs the whole mission. Callbacks must be served by another thread.
  /// @return whether all robots have arrived
  /// @throws std::runtime_error if the planner does not appear in time, does not come back or hangs
  bool run();

  /// Whether the command ends with the mission.
  bool exitWhenDone() const { return options_.exit_when_done; }

 private:
  using Client = actionlib::SimpleActionClient<sylph_msgs::ExecuteMissionAction>;
  using Clock = std::chrono::steady_clock;

  void waitForServer(Clock::time_point deadline);
  /// Returns at the deadline too.
  void waitForPoses(Clock::time_point deadline);
  void sendMission();
  /// Returns when the mission has ended. A planner that was started again gets the mission anew: it
  /// goes on with the plan that is being carried out.
  void waitForResult();
  void onDiagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics);
  /// Lab time stands still until the planner has the mission.
  void joinLockStep();
  void onFeedback(const sylph_msgs::ExecuteMissionFeedbackConstPtr& feedback);
  void printRunReport();
  /// What may be why the mission waits, one line each: robots in another namespace, nodes that
  /// cannot be reached, and what the motion capture says is wrong with it.
  void sayFindings();
  /// Looks at most every ten seconds, in a thread: names may take long to look up. mutex_ is held.
  const std::vector<std::string>& networkFindings();

  ros::NodeHandle nh_;
  ClientOptions options_;
  sylph::Experiment experiment_;
  sylph_msgs::ExecuteMissionGoal mission_;
  std::string headline_;
  Client client_;
  std::mutex mutex_;
  sylph_ros::CaptureFindings capture_findings_;
  ros::Subscriber diagnostics_subscriber_;
  std::shared_ptr<sylph_ros::LockStep> lock_step_;      ///< null unless the lab is in lock step
  std::atomic<bool> is_accepted_{false};                ///< the mission, by the planner
  std::vector<std::string> network_findings_;           ///< as of the last look
  std::future<std::vector<std::string>> reachability_;  ///< a look that is under way
  Clock::time_point reachability_asked_;
  /// When the result that stood in the run folder before this mission was written.
  std::optional<std::filesystem::file_time_type> old_result_;
  std::string last_headline_;
  Clock::time_point printed_at_;
};

}  // namespace sylph_planner_node
