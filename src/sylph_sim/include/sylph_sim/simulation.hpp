#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_sim/cameras.hpp"
#include "sylph_sim/contact_monitor.hpp"
#include "sylph_sim/fault.hpp"
#include "sylph_sim/mecanum_base.hpp"

namespace sylph_sim {

/// Everything about the simulated lab that the experiment does not say.
struct SimulationOptions {
  double step_rate_hz = 200.0;         ///< steps a simulated second
  double start_offset_m = 0.004;       ///< robots start this far off their cell's centre at most
  double start_yaw_offset_rad = 0.02;  ///< and turned by this much at most
  BaseOptions base;
  CameraOptions cameras;
};

/// Shows each number with its bounds and meaning, without those of base and cameras.
void visitNumbers(SimulationOptions& options, const NumberVisitor& visit);

/// @throws std::invalid_argument naming the member, its value and its bound
void requireValid(const SimulationOptions& options);

/// The simulated lab: robots, cameras, faults, and the truth about them. Steps through time by
/// itself; the same experiment, seed and commands give the same run.
class Simulation {
 public:
  /// @param start_s  simulated time at the start [s], >= 0
  /// @throws std::invalid_argument as requireValid(), or if the experiment has no robot
  Simulation(const SimulationOptions& options, const sylph::Experiment& experiment, double start_s);

  /// A velocity command to one robot, in its frame, that arrives now.
  /// @throws std::out_of_range if there is no such robot
  void command(std::size_t robot, const sylph::Twist2d& twist_robot);

  /// Adds a fault of the script: its time counts from the first command that is not zero.
  /// @throws std::invalid_argument as FaultScript::add()
  void schedule(const Fault& fault);
  /// Adds a fault whose time counts from now.
  /// @throws std::invalid_argument as FaultScript::add()
  void inject(const Fault& fault);

  /// Moves on by one step.
  /// @return frames that leave the cameras in it, oldest first
  std::vector<CapturedFrame> step();

  double time() const { return time_s_; }          ///< simulated time [s]
  double stepDuration() const { return step_s_; }  ///< [s]
  /// True poses in the map, one a robot.
  const std::vector<sylph::Pose2d>& poses() const { return poses_; }
  double minSeparation() const { return contacts_.minSeparation(); }  ///< see ContactMonitor
  /// How often two footprints began to touch.
  std::uint32_t collisions() const { return contacts_.collisions(); }
  /// How often a robot's centre left the free cells.
  std::uint32_t obstacleEntries() const { return obstacle_entries_; }
  /// Faults in effect now.
  std::size_t activeFaults() const { return script_.activeCount(time_s_); }

 private:
  void placeRobots();
  void updateTruth();

  SimulationOptions options_;
  sylph::Experiment experiment_;
  sylph::CellFrame cell_frame_;
  double start_s_;
  double step_s_;
  std::int64_t steps_ = 0;
  double time_s_;
  std::vector<MecanumBase> bases_;
  std::vector<sylph::Pose2d> poses_;
  std::optional<Cameras> cameras_;
  FaultScript script_;
  FaultState faults_;
  std::vector<Fault> not_begun_;  // scripted faults until the first robot is told to move
  bool has_begun_ = false;
  ContactMonitor contacts_;
  std::vector<bool> is_in_obstacle_;
  std::uint32_t obstacle_entries_ = 0;
};

}  // namespace sylph_sim
