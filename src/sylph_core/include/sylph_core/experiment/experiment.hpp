#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// One robot of an experiment. Lengths in metres.
struct RobotSpec {
  std::string name;        ///< `robot_0`, ...; also its namespace and its tf frame
  std::string rigid_body;  ///< name in the motion-capture system; `name` unless given
  double length_m = 0.23;  ///< footprint along the robot's x axis, > 0
  double width_m = 0.20;   ///< footprint along the robot's y axis, > 0
  Cell start;              ///< where the simulator puts it; a real robot starts where it stands
  Cell goal;
};

/// What robots may do and what the lab measures, shared by every node: one source of these numbers.
struct ExecutionSpec {
  double speed_limit_mps = 0.25;         ///< > 0
  double acceleration_limit_mps2 = 0.6;  ///< > 0
  double turn_rate_limit_radps = 0.5;    ///< > 0
  double position_tolerance_m = 0.010;   ///< a task is DONE within this distance of its end, > 0
  double heading_tolerance_rad =
      0.0524;                       ///< heading error that robots hold at all times (3 deg), > 0
  double tracking_error_m = 0.012;  ///< largest distance from the planned segment, > 0
  double pose_timeout_s = 0.1;      ///< a pose older than this is stale, > 0
  double base_timeout_s = 0.1;      ///< a base stops by itself so long after a command, > 0
  double command_latency_s = 0.05;  ///< from capture to a moving wheel, >= 0
};

/// How the mission is planned.
struct PlanningSpec {
  std::string planner = "lacam";  ///< name, as makePlanner() takes it
  std::string weights_path;       ///< of the policy, absolute; empty: none
  double time_limit_s = 5.0;      ///< > 0
};

/// A lab experiment: everything that its nodes have to agree on.
struct Experiment {
  std::string name;               ///< file stem
  std::string path;               ///< of the experiment file
  std::string map_path;           ///< absolute
  Grid grid;                      ///< the map
  double cell_size_m = 0.3;       ///< side of a cell, > 0
  Point corner;                   ///< lower left, in frame `map` [m]: a map_server map's `origin`
  std::vector<RobotSpec> robots;  ///< one or more; agent i is robot i
  std::uint32_t seed = 0;         ///< of what is random
  PlanningSpec planning;          ///< how the mission is planned
  ExecutionSpec execution;        ///< how it is carried out
};

/// Settings that take the place of the file's, as launch arguments do.
struct ExperimentOverrides {
  std::optional<std::uint32_t> seed;                       ///< redraws what the file calls `random`
  std::optional<std::string> planner;                      ///< name
  std::optional<std::string> weights_path = std::nullopt;  ///< of the policy
};

/// Reads an experiment file (YAML) and its map.
///
///     map: lab_maze.map            # required; taken from the experiment file's folder
///     cell_size_m: 0.3             # of a map_server map its resolution unless given; see below
///     footprint_m: [0.23, 0.20]    # [length, width] of robots that do not name their own
///     starts: random               # random | explicit (the default): from each robot's `start`
///     goals: random                # random | explicit (the default): from each robot's `goal`
///     seed: 1                      # of what is random, 0 ... 4294967295
///     robots:                      # required, one or more
///       - {name: robot_0, rigid_body: robot_0, footprint_m: [0.23, 0.20],
///          start: [0, 1], goal: [4, 2]}
///     planning: {planner: lacam, weights: sylph.safetensors, time_limit_s: 5.0}
///     execution: {speed_limit_mps: 0.25}  # and the other members of ExecutionSpec
///
/// Where cell_size_m is more than a map_server map's resolution, a cell is free if its whole
/// square, grown by what the largest footprint reaches beyond its cell, is free (grid/coarsen.hpp).
///
/// Weights are taken from the experiment file's folder and are read by who plans with them.
/// Of a robot only `name` is required, and `start` and `goal` exactly where they are explicit. What
/// is left out keeps the default of the structs above. Starts and goals satisfy requireValid().
///
/// @throws std::runtime_error with one line: file, line, field, what is wrong, what is allowed.
/// Unknown keys are errors.
Experiment loadExperiment(const std::string& path, const ExperimentOverrides& overrides = {});

/// Writes an experiment as a file that loadExperiment() reads: starts and goals are explicit, maps
/// and weights are named by their absolute paths unless they lie in the file's own folder.
/// @throws std::runtime_error naming the file if it is there already or cannot be written
void saveExperiment(const Experiment& experiment, const std::string& path);

/// Another map in the experiment's cells, made of its file as the experiment's own is.
/// @throws std::runtime_error with one line if the file is no map, its cells are larger or it lies
/// elsewhere
Grid loadMapFor(const Experiment& experiment, const std::string& path);

/// Where the experiment's cells lie in frame `map`.
CellFrame cellFrameOf(const Experiment& experiment);

/// Names of its robots, in their order.
std::vector<std::string> namesOf(const Experiment& experiment);

/// Starts and goals as a planning instance without rotations.
Instance toInstance(const Experiment& experiment);

}  // namespace sylph
