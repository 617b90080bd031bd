#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_rehearsal/link.hpp"
#include "sylph_sim/fault.hpp"

namespace sylph_rehearsal {

/// What can go wrong in the lab besides robots and cameras. In a schedule the names are the same in
/// snake_case.
enum class LabFaultKind {
  Simulated,      ///< of a robot or the cameras, as sylph_sim has it
  Network,        ///< messages between central node and robots travel worse
  PoseNetwork,    ///< those of poses to robots do
  CrashCentral,   ///< the central node ends, and starts again after the duration
  CrashRobot,     ///< a robot's node does
  CrashPlanner,   ///< the planner's does
  LaunchAnew,     ///< the operator ends both and launches them again, with an empty event log
  CrashBridge,    ///< the bridge's does
  ClockSkew,      ///< the clock of a robot is `value` seconds ahead
  Pause,          ///< the operator pauses, and resumes after the duration
  Stop,           ///< the operator stops, and resumes after the duration
  EmergencyStop,  ///< the button is pressed; released after the duration, the operator resumes
  DeclareLost,    ///< the operator declares a robot lost
};

/// One thing that goes wrong. `at_s` counts from the start of the run [s].
struct LabFault {
  LabFaultKind kind = LabFaultKind::Simulated;  ///< decides which of the others count
  sylph_sim::Fault fault;  ///< robots (empty: all), begin, duration, value, whatever the kind
  LinkOptions link;        ///< of Network and PoseNetwork
};

/// As in a schedule: "stuck", "network", "crash_central", ...
std::string toName(const LabFault& fault);
/// As in a schedule, on one line: "{kind: stuck, robots: [robot_3], at_s: 2, duration_s: 0.5}".
std::string toYaml(const LabFault& fault, const sylph::Experiment& experiment);

/// Reads a schedule (YAML):
///
///     faults:
///       - {kind: stuck, robots: [robot_3], at_s: 2.0, duration_s: 0.5}
///       - {kind: network, at_s: 1.0, duration_s: 5.0, delay_s: 0.1, jitter_s: 0.1, loss: 0.2}
///
/// @throws std::runtime_error with one line: file, line, field, what is wrong, what is allowed
std::vector<LabFault> loadFaults(const std::string& path, const sylph::Experiment& experiment);

/// Some faults at once, all of them within what the lab promises to survive: they cost time or stop
/// robots, but no robot touches another one.
std::vector<LabFault> randomFaults(const sylph::Experiment& experiment, sylph::Rng& rng);

}  // namespace sylph_rehearsal
