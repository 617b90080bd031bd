#pragma once

#include <memory>
#include <vector>

#include "sylph_core/geometry/footprint.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// How a robot may stand where its plan starts, for the largest robot: its footprint, as it is
/// turned, keeps to the middle of its cell.
struct StartLimits {
  double length_m = 0.23;  ///< of the footprint, > 0
  double width_m = 0.2;    ///< > 0
  /// From the cell's centre, along each axis: half the cell, less what a neighbour that loses its
  /// pose at the worst moment may reach into it [m], > 0.
  double room_m = 0.142;
};

/// Where a robot may be aligned: turned and driven to the middle of its cell while all others rest.
struct AlignmentLimits {
  std::vector<Footprint> footprints;  ///< of each robot of the lab; where they are does not matter
  Grid obstacles;                     ///< of the lab
  /// Least gap to other robots and to obstacles on the way [m]. Who only moves away needs half of
  /// it to robots, and none to obstacles.
  double clearance_m = 0.03;
};

/// When something counts as wrong. Times in seconds of the caller's steady clock.
struct ExecutionLimits {
  int lookahead = 5;            ///< tasks that a robot may have ahead, > 0
  double resend_after_s = 0.3;  ///< a task that is not accepted is sent again, > 0
  double silent_after_s = 1.0;  ///< > 0
  double stuck_after_s = 5.0;   ///< > 0
  double lost_after_s = 0.0;    ///< trouble for so long makes a robot lost; 0: never by itself
  double start_wait_s = 60.0;   ///< a plan waits so long for robots to rest and report, > 0
  double progress_m = 0.02;     ///< a robot that moves so far makes progress, > 0
  StartLimits start;
  /// Robots that stand in their start cells, but off the middle, are aligned; null: they are not.
  std::shared_ptr<const AlignmentLimits> alignment;
};

}  // namespace sylph
