#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <optional>
#include <string>
#include <vector>

#include "sylph_core/control/separation.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_ros/parameter_reader.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_adg_central {

/// Settings of the separation monitor.
struct SeparationMonitorOptions {
  sylph::SeparationLimits limits;
  double rate_hz = 20.0;        ///< how often the state is published
  double pose_timeout_s = 0.5;  ///< a pose older than this is called stale in the state
};

/// Parameters of sylph_separation_monitor, with meaning and bounds.
/// @throws std::runtime_error with one line on a bad parameter
SeparationMonitorOptions readSeparationMonitorOptions(sylph_ros::ParameterReader& reader);

/// @throws std::runtime_error with one line on a bad or unknown parameter, on a limit that robots
/// undercut although they keep to their tolerances, and if there is no safety margin
SeparationMonitorOptions loadSeparationMonitorOptions(const ros::NodeHandle& private_nh,
                                                      const sylph::Experiment& experiment);

/// Stops all robots when two come too close. It trusts nobody: it sees the poses itself and tells
/// the robots itself, past the central node. Robots stay stopped until the service
/// kSeparationResetService is called, which is refused as long as they are too close, and then the
/// central node's resume.
class SeparationMonitorNode {
 public:
  /// @throws std::runtime_error as loadSeparationMonitorOptions()
  SeparationMonitorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  void onPose(int robot, const geometry_msgs::PoseStamped& message);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void onTimer();
  void publishStop();
  void publishState();
  void reportDiagnostics(diagnostic_updater::DiagnosticStatusWrapper& status);
  std::string describe(const sylph::PairGap& pair) const;
  const std::string& name(int robot) const;

  ros::NodeHandle nh_;
  sylph_ros::SteadyClock clock_;
  sylph::Experiment experiment_;
  SeparationMonitorOptions options_;
  sylph::SeparationWatch watch_;
  std::vector<std::optional<double>> received_s_;  ///< steady time of each robot's last pose
  bool is_violated_ = false;

  std::vector<ros::Subscriber> subscribers_;
  sylph_ros::Publisher stop_publisher_;
  sylph_ros::Publisher state_publisher_;
  ros::ServiceServer reset_service_;
  sylph_ros::Timer timer_;
  diagnostic_updater::Updater diagnostics_;
};

}  // namespace sylph_adg_central
