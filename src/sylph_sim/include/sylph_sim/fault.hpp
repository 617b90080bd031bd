#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "sylph_sim/mecanum_base.hpp"

namespace sylph_sim {

/// What can go wrong on purpose. The names in a fault script are the same in snake_case.
enum class FaultKind {
  Stuck,    ///< the robot's wheels do not move it
  Slow,     ///< its wheels do `value` times what they should; above 1 it overshoots
  Dead,     ///< it has no power from now on, whatever the duration
  Deaf,     ///< commands to it get lost; it latches the last one until its time-out
  Drift,    ///< it is pushed to its left at `value` m/s
  Lost,     ///< the cameras do not track its body
  Nan,      ///< its body's pose is not a number, though marked as tracked
  Frozen,   ///< its body's pose stays as it was, with fresh stamps
  YawFlip,  ///< its body is turned by `value` rad
  Jump,     ///< its body is moved by `value` m along map x
  Swap,     ///< the bodies of two robots are taken for each other
  Silent,   ///< no frame leaves the cameras at all
};

/// One fault. `robots` are indices, ascending or not.
struct Fault {
  FaultKind kind = FaultKind::Stuck;
  std::vector<std::size_t> robots;  ///< empty: all
  double at_s = 0.0;                ///< since the first robot was told to move [s], >= 0
  double duration_s = std::numeric_limits<double>::infinity();  ///< > 0
  double value = 0.0;  ///< meaning and unit as FaultKind says
};

/// @throws std::invalid_argument if the name is none; it lists those that are
FaultKind faultKindFromName(const std::string& name);
/// As in a fault script.
std::string toName(FaultKind kind);
/// What `value` is where a script gives none.
double defaultValue(FaultKind kind);

/// What is wrong with how the cameras see one robot at one moment.
struct CaptureFault {
  bool is_lost = false;         ///< not tracked
  bool is_nan = false;          ///< tracked, and not a number
  bool is_frozen = false;       ///< stays as it was
  double yaw_offset_rad = 0.0;  ///< its pose is turned by this
  double x_offset_m = 0.0;      ///< and moved along map x by this
  std::size_t shown_robot = 0;  ///< whose pose its body shows: itself unless swapped
};

/// Everything that is wrong with one robot at one moment.
struct RobotFault {
  BaseFault base;        ///< of its drive
  bool is_deaf = false;  ///< gets no command
  CaptureFault capture;  ///< of what the cameras see of it
};

/// Everything that is wrong at one moment.
struct FaultState {
  std::vector<RobotFault> robots;  ///< one a robot
  bool is_silent = false;          ///< no frame leaves the cameras
};

/// Faults over time.
class FaultScript {
 public:
  /// @throws std::invalid_argument if robot_count is 0
  explicit FaultScript(std::size_t robot_count);

  /// Adds a fault whose `at_s` counts from `origin_s` of the simulated time.
  /// @throws std::invalid_argument naming the member that is wrong and what is allowed
  void add(const Fault& fault, double origin_s);

  /// What is wrong at `time_s`.
  FaultState stateAt(double time_s) const;

  /// How many faults are in effect at `time_s`.
  std::size_t activeCount(double time_s) const;

 private:
  struct Scheduled {
    Fault fault;
    double start_s;
    double end_s;
  };

  std::size_t robot_count_;
  std::vector<Scheduled> faults_;
};

}  // namespace sylph_sim
