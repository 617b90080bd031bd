#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sylph_core/benchmark/external_solver.hpp"
#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// A map from a file with a scenario for each instance.
struct StoredInstances {
  std::string map_path;                     ///< as loadMap() takes it
  std::vector<std::string> scenario_paths;  ///< MovingAI .scen, one an instance
};

/// A map and agents drawn for each instance k from seed + k.
struct GeneratedInstances {
  std::variant<RandomMapSpec, RoomMapSpec, MazeMapSpec> map;  ///< its generator and sizes
  int instances = 20;                                         ///< > 0
  std::uint32_t seed = 0;                                     ///< of the first instance
};

/// Instances of one kind, each with several numbers of agents: the first N of the same scenario.
struct BenchmarkFamily {
  std::string name;                                          ///< as in the table
  std::variant<StoredInstances, GeneratedInstances> source;  ///< where its instances come from
  std::vector<int> agents;                                   ///< each > 0
};

/// What sylph_benchmark runs.
struct BenchmarkSuite {
  std::vector<std::string> planners;      ///< names, as makePlanner() takes them
  std::vector<std::string> ablations;     ///< of the policy-guided ones, see ablationNames()
  std::vector<ExternalSolver> external;   ///< what runs on the same cases
  PlanningLimits limits;                  ///< of each run
  MotionModel motion;                     ///< of all instances
  std::vector<BenchmarkFamily> families;  ///< one or more
};

/// One instance with one number of agents.
struct BenchmarkCase {
  std::string family;       ///< its name
  int instance_number = 0;  ///< within the family, from 0
  std::uint32_t seed = 0;   ///< for the planner
  Instance instance;        ///< what is to be planned
};

/// Reads a suite (YAML).
///
///     planners: [lacam]        # the default planner unless given
///     time_limit_s: 10         # and, as in PlanningLimits and MotionModel,
///     max_steps: 10000
///     first: false
///     rotations: false
///     ablations: [random_svo_per_step]  # policy-guided planners run with each as well
///     external:                # programs that run on the same cases
///       - {name: lacam3, command: "main -m {map} -i {scen} -N {agents} -t {seconds} -o {plan}",
///          plan_format: lacam, grace_s: 5}
///     families:                # required, one or more, of either kind
///       - {name: rooms, agents: [100, 200], instances: 20, seed: 1,
///          generator: room, rows: 32, cols: 32, room_size: 3, door_width: 1, door_share: 0.9}
///       - {name: warehouse, agents: [50], map: a.map, scenarios: [a-1.scen, a-2.scen]}
///
/// Generators are random (density), room (as above) and maze (corridor_width, opened_share); what
/// is left out keeps the default of its specification. Files are taken from the suite's folder.
///
/// @throws std::runtime_error with one line: file, line, field, what is wrong, what is allowed
BenchmarkSuite loadSuite(const std::string& path);

/// How many run on each case: planners, their ablations, external solvers.
std::size_t entrantCount(const BenchmarkSuite& suite);

/// Every case of a suite: families in order, instances in order, numbers of agents in order.
/// @throws std::runtime_error if a map or a scenario cannot be used, as its reader
/// @throws std::invalid_argument naming the family if its agents do not fit on its map
std::vector<BenchmarkCase> makeCases(const BenchmarkSuite& suite);

}  // namespace sylph
