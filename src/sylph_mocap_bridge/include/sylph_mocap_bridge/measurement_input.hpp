#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <vector>

#include "sylph_mocap_bridge/preflight.hpp"
#include "sylph_mocap_bridge/robot_tracks.hpp"

namespace sylph_mocap_bridge {

/// ROS time that goes back by more than this began anew [s], as a simulation's or a bag's does.
constexpr double kTimeJump_s = 0.5;

/// Takes what an input measured. Called from the input's thread.
class MeasurementSink {
 public:
  virtual ~MeasurementSink() = default;

  /// @param measurements  of one instant
  /// @param now_s         local (ROS) time
  virtual void onMeasurements(const std::vector<Measurement>& measurements, double now_s) = 0;
  /// The clocks began anew.
  virtual void onRestart() = 0;
};

/// A source of measurements. It feeds its sink from its construction on.
class MeasurementInput {
 public:
  virtual ~MeasurementInput() = default;

  /// Adds what is worth knowing to a diagnostic report. Called about once a second.
  /// @return what is wrong on the way from the cameras
  virtual Finding look(diagnostic_updater::DiagnosticStatusWrapper& report) = 0;
};

}  // namespace sylph_mocap_bridge
