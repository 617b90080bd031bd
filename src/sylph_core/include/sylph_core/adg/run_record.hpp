#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sylph_core/adg/execution.hpp"
#include "sylph_core/execution/event_line.hpp"
#include "sylph_core/execution/states.hpp"

namespace sylph {

/// What there is to say of a mission when it is over.
struct RunResult {
  bool success = false;  ///< every robot is on its goal, and ground truth, if heard, saw no contact
  std::string message;   ///< how it ended
  std::string planner;
  int robots = 0;                ///< of the mission, lost ones included
  int arrived = 0;               ///< of them, on their goals
  std::uint32_t plan_steps = 0;  ///< of the last plan, as is sum_of_costs
  long sum_of_costs = 0;         ///< [timesteps]
  double planning_s = 0.0;       ///< wall time of all plans [s]
  double execution_s = 0.0;      ///< ROS time from the first task released to the last one done [s]
  int critical_path_cells = 0;   ///< moves in the longest chain of dependencies
  double ideal_execution_s = 0.0;           ///< critical path at the speed limit [s]
  std::optional<double> min_separation_m;   ///< between footprints; nothing if nobody measured it
  double max_tracking_error_m = 0.0;        ///< of all robots, from the planned segments
  int replans = 0;                          ///< plans that took over from an unfinished one
  int stops = 0;                            ///< times that the mode went to Stop
  std::optional<std::uint32_t> collisions;  ///< of the ground truth of a simulation
};

/// Sums up a mission from what happens, and from what happened before a restart.
class RunRecord {
 public:
  /// Takes an event, with the ROS time at which it was logged.
  void add(const StampedEvent& entry);
  /// A robot's distance from its planned segment [m]; the largest counts.
  void addTrackingError(double error_m);
  /// The smallest gap between footprints so far [m], by the separation monitor.
  void setMinSeparation(double separation_m) { min_separation_m_ = separation_m; }
  /// Contacts so far, by the ground truth of a simulation.
  void setCollisions(std::uint32_t collisions) { collisions_ = collisions; }

  /// ROS time since the first task was released; until the last one was done once it is over [s].
  double elapsed(double stamp_s, bool is_over) const;

  /// @param cell_s  time for one cell at the speed limit [s]
  RunResult result(const Execution& execution, double cell_s) const;

 private:
  std::optional<double> first_released_s_;
  double last_done_s_ = 0.0;
  double planning_s_ = 0.0;
  int replans_ = 0;
  int stops_ = 0;
  ExecutionMode mode_ = ExecutionMode::Run;
  double max_tracking_error_m_ = 0.0;
  std::optional<double> min_separation_m_;
  std::optional<std::uint32_t> collisions_;
};

}  // namespace sylph
