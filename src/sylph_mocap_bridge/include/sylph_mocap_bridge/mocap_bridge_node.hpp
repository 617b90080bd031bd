#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_mocap_bridge/measurement_input.hpp"
#include "sylph_mocap_bridge/options.hpp"
#include "sylph_mocap_bridge/preflight.hpp"
#include "sylph_mocap_bridge/robot_publishers.hpp"
#include "sylph_mocap_bridge/robot_tracks.hpp"
#include "sylph_ros/steady_clock.hpp"

namespace sylph_mocap_bridge {

/// Poses, velocities and tf of the experiment's robots, from motion capture. README.md has topics
/// and parameters.
class MocapBridgeNode : public MeasurementSink {
 public:
  /// @throws std::runtime_error on a bad parameter, experiment or network address
  MocapBridgeNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  void onMeasurements(const std::vector<Measurement>& measurements, double now_s) override;
  void onRestart() override;

 private:
  std::unique_ptr<MeasurementInput> makeInput();
  void reportLink(diagnostic_updater::DiagnosticStatusWrapper& report);
  void reportBodies(diagnostic_updater::DiagnosticStatusWrapper& report);

  ros::NodeHandle nh_;
  sylph::Experiment experiment_;
  Options options_;
  sylph_ros::SteadyClock clock_;
  std::mutex mutex_;
  RobotTracks tracks_;          ///< guarded by mutex_
  RobotPublishers publishers_;  ///< of the input's thread alone
  std::vector<TrackCounts> seen_counts_;
  Announcer announcer_;
  std::unique_ptr<MeasurementInput> input_;
  diagnostic_updater::Updater updater_;
  sylph_ros::Timer diagnostics_timer_;
};

}  // namespace sylph_mocap_bridge
