#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/adg/run_record.hpp"
#include "sylph_core/control/pose_predictor.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/policy/policy.hpp"
#include "sylph_rehearsal/lab_fault.hpp"
#include "sylph_rehearsal/link.hpp"
#include "sylph_sim/simulation.hpp"

namespace sylph_rehearsal {

/// The lab as it is rehearsed: what the experiment does not say of it. Times are the lab's.
struct RehearsalOptions {
  sylph_sim::SimulationOptions simulation;  ///< bases and cameras
  sylph::BaseModel base{0.025, 0.08};       ///< what controllers take a base for
  double control_rate_hz = 50.0;            ///< of each robot's controller, > 0
  double report_rate_hz = 10.0;             ///< of each robot, > 0
  double heartbeat_period_s = 0.1;          ///< of the central node, > 0
  sylph::ExecutionLimits limits;            ///< of the central node; the start offset is derived
  LinkOptions cameras;                      ///< from the bridge to each robot and the monitor
  LinkOptions network;                      ///< between central node and robots
  LinkOptions computer;                     ///< between nodes of one computer
  bool align = false;          ///< robots off the middle of their starts are aligned first
  double planning_s = 0.5;     ///< that the planner takes, >= 0
  double quiet_s = 30.0;       ///< a run in which no task is done for so long has stopped, > 0
  double time_limit_s = 3600;  ///< a run ends then at the latest, > 0
};

/// @throws std::invalid_argument naming the member, its value and its bound
void requireValid(const RehearsalOptions& options);

/// How a run ends.
enum class Ending {
  Finished,  ///< every robot is on its goal
  Stopped,   ///< nothing moves any more; `cause` says why
  Violated,  ///< something happened that must never happen
};

/// In a word, for tables.
std::string toString(Ending ending);

/// Something that must never happen, by the truth.
struct Violation {
  double time_s = 0.0;  ///< since the start of the run
  std::string what;     ///< in one line, with the robots' names
};

/// How long a robot had to wait for another one.
struct WaitingTime {
  int robot = 0;            ///< that waited
  int blocker = 0;          ///< that it waited for
  double duration_s = 0.0;  ///< in all [s]
};

/// A robot that drove when the emergency stop was pressed.
struct EmergencyBraking {
  int robot = 0;            ///< its index in the experiment
  double speed_mps = 0.0;   ///< when it was pressed
  double distance_m = 0.0;  ///< from then to standstill
  double duration_s = 0.0;  ///< likewise
};

/// What became of a run.
struct Rehearsal {
  std::uint32_t seed = 0;                  ///< gives the same run again
  Ending ending = Ending::Stopped;         ///< the worst of what happened
  std::string cause;                       ///< why it did not finish
  std::vector<LabFault> faults;            ///< that went wrong
  sylph::RunResult result;                 ///< as the central node sums it up
  double lab_s = 0.0;                      ///< time of the lab that the run took
  std::vector<Violation> violations;       ///< in order of time; none unless `ending` is Violated
  std::vector<WaitingTime> waits;          ///< in order of robot and blocker
  std::vector<EmergencyBraking> brakings;  ///< by the truth, in order of standstill
  std::vector<std::string> event_log;      ///< of the central node, a line an event
};

/// Runs the mission of an experiment, from its robots' starts to its goals, in the simulated lab:
/// every decision is made by the classes that make it in the real one. The same experiment and
/// options give the same run, whatever else the computer does.
/// @param policy  of the planner, nullptr if it needs none
/// @param faults  what goes wrong
/// @throws std::runtime_error if the experiment has no safety margin
/// @throws std::invalid_argument as requireValid(), or if its planner is unknown or needs a policy
Rehearsal rehearse(const sylph::Experiment& experiment, const RehearsalOptions& options,
                   const std::shared_ptr<const sylph::Policy>& policy,
                   const std::vector<LabFault>& faults = {});

}  // namespace sylph_rehearsal
