#include "sylph_core/experiment/experiment.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiment/execution_members.hpp"
#include "files/text_file.hpp"
#include "sylph_core/experiment/experiment_margin.hpp"
#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/grid/coarsen.hpp"
#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

/// Names of ROS graph resources without namespaces: they become namespaces and frames.
bool isRosName(const std::string& name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto isAllowed = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && isLetter(name.front()) &&
         std::all_of(name.begin(), name.end(), isAllowed);
}

/// Where cells come from: a robot's own field, or a draw in which the field has no place.
Cell readCell(const YamlMap& yaml, const std::string& key, bool is_random) {
  if (!is_random) {
    return yaml.cell(key);
  }
  if (yaml.has(key)) {
    // A cell that is written down and not used would mislead whoever reads the file.
    throw yaml.error(key, "has no place here, '" + key + "s: random' draws it");
  }
  return {};
}

RobotSpec readRobot(const YamlMap& yaml, const std::vector<double>& footprint_m,
                    bool has_random_start, bool has_random_goal) {
  RobotSpec robot;
  robot.name = yaml.text("name");
  if (!isRosName(robot.name)) {
    throw yaml.error("name", inQuotes(robot.name) +
                                 ", must be a letter followed by letters, digits and underscores");
  }
  // Most labs call the body as the robot.
  robot.rigid_body = yaml.text("rigid_body", robot.name);
  const std::vector<double> own_m =
      yaml.has("footprint_m") ? yaml.numbers("footprint_m", 2, Range::positive()) : footprint_m;
  robot.length_m = own_m[0];
  robot.width_m = own_m[1];
  robot.start = readCell(yaml, "start", has_random_start);
  robot.goal = readCell(yaml, "goal", has_random_goal);
  yaml.refuseUnread();
  return robot;
}

std::vector<RobotSpec> readRobots(const YamlMap& yaml, bool has_random_starts,
                                  bool has_random_goals) {
  const RobotSpec defaults;
  const std::vector<double> footprint_m =
      yaml.has("footprint_m") ? yaml.numbers("footprint_m", 2, Range::positive())
                              : std::vector<double>{defaults.length_m, defaults.width_m};
  std::vector<RobotSpec> robots;
  std::set<std::string> names;
  std::set<std::string> rigid_bodies;
  for (const YamlMap& entry : yaml.maps("robots")) {
    robots.push_back(readRobot(entry, footprint_m, has_random_starts, has_random_goals));
    if (!names.insert(robots.back().name).second) {
      throw entry.error("name", inQuotes(robots.back().name) + " is another robot's name too");
    }
    if (!rigid_bodies.insert(robots.back().rigid_body).second) {
      throw entry.error("rigid_body",
                        inQuotes(robots.back().rigid_body) + " is another robot's rigid body too");
    }
  }
  return robots;
}

PlanningSpec readPlanning(const YamlMap& yaml) {
  PlanningSpec spec;
  spec.planner = yaml.word("planner", plannerNames(), spec.planner);
  if (yaml.has("weights")) {
    spec.weights_path = resolvePath(yaml.path(), yaml.text("weights"));
  }
  spec.time_limit_s = yaml.number("time_limit_s", spec.time_limit_s, Range::positive());
  yaml.refuseUnread();
  return spec;
}

ExecutionSpec readExecution(const YamlMap& yaml) {
  ExecutionSpec spec;
  for (const ExecutionMember& member : kExecutionMembers) {
    spec.*member.value = yaml.number(member.key, spec.*member.value, member.range());
  }
  yaml.refuseUnread();
  return spec;
}

/// Of the name that takes the place of the file's, which no field of the file can be blamed for.
void requireKnownPlanner(const std::string& name) {
  const std::vector<std::string>& known = plannerNames();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw std::runtime_error("planner " + inQuotes(name) + ": must be one of " + join(known));
  }
}

/// The cell size and where the map comes from; its cells wait for the robots' footprints.
MapFile readMap(const YamlMap& yaml, Experiment& experiment) {
  experiment.map_path = resolvePath(experiment.path, yaml.text("map"));
  MapFile map = loadMapFile(experiment.map_path);
  const double otherwise_m = map.cell_size_m.value_or(experiment.cell_size_m);
  experiment.cell_size_m = yaml.number("cell_size_m", otherwise_m, Range::positive());
  if (map.origin_yaw_rad != 0.0) {
    throw fileError(experiment.map_path, 0,
                    "origin: has a yaw of " + shortNumber(map.origin_yaw_rad) +
                        " rad, must be 0: cells lie along the axes of the map, turn the image");
  }
  experiment.corner = {map.origin_x_m, map.origin_y_m};
  return map;
}

/// How far a robot that stands in its cell may reach beyond the cell's edges [m].
double marginOf(const Experiment& experiment) {
  const SafetyMargin margin = computeSafetyMargin(safetyFactors(experiment));
  return std::max(0.0, margin.reach_m + margin.error_m - experiment.cell_size_m / 2.0);
}

/// @throws std::invalid_argument if there is no such map
Grid inCellsOf(const Experiment& experiment, const MapFile& map) {
  if (!map.cell_size_m || *map.cell_size_m == experiment.cell_size_m) {
    return map.grid;
  }
  if (*map.cell_size_m > experiment.cell_size_m) {
    throw std::invalid_argument("is finer than the map's resolution of " +
                                shortNumber(*map.cell_size_m) + " m, must be at least that");
  }
  return coarsened(map.grid, *map.cell_size_m, experiment.cell_size_m, marginOf(experiment));
}

/// Draws what is random and refuses starts and goals that no planner could serve.
void placeRobots(bool has_random_starts, bool has_random_goals, Experiment& experiment) {
  Rng rng(experiment.seed);
  Instance instance = toInstance(experiment);
  if (has_random_starts && has_random_goals) {
    instance.starts = drawCells(instance.grid, instance.agentCount(), rng);
  } else if (has_random_starts) {
    instance.starts = drawReachableCells(instance.grid, instance.goals, rng);
  }
  if (has_random_goals) {
    instance.goals = drawReachableCells(instance.grid, instance.starts, rng);
  }
  // Drawn cells can be reached by how they are drawn; explicit ones have to be looked at.
  requireValid(instance);
  for (std::size_t agent = 0; agent < experiment.robots.size(); ++agent) {
    experiment.robots[agent].start = instance.starts[agent];
    experiment.robots[agent].goal = instance.goals[agent];
  }
}

}  // namespace

Experiment loadExperiment(const std::string& path, const ExperimentOverrides& overrides) {
  const YamlMap yaml = YamlMap::load(path);
  Experiment experiment;
  experiment.path = path;
  experiment.name = std::filesystem::path(path).stem().string();
  const MapFile map = readMap(yaml, experiment);

  const std::vector<std::string> sources = {"random", "explicit"};
  const bool has_random_starts = yaml.word("starts", sources, "explicit") == "random";
  const bool has_random_goals = yaml.word("goals", sources, "explicit") == "random";
  const auto seed = static_cast<std::uint32_t>(
      yaml.integer("seed", 0, 0, std::numeric_limits<std::uint32_t>::max()));
  experiment.seed = overrides.seed.value_or(seed);
  experiment.robots = readRobots(yaml, has_random_starts, has_random_goals);
  if (const auto planning = yaml.map("planning")) {
    experiment.planning = readPlanning(*planning);
  }
  if (const auto execution = yaml.map("execution")) {
    experiment.execution = readExecution(*execution);
  }
  yaml.refuseUnread();
  try {
    experiment.grid = inCellsOf(experiment, map);
  } catch (const std::invalid_argument& error) {
    throw yaml.error("cell_size_m", error.what());
  }
  if (overrides.planner) {
    requireKnownPlanner(*overrides.planner);
    experiment.planning.planner = *overrides.planner;
  }
  if (overrides.weights_path) {
    experiment.planning.weights_path = *overrides.weights_path;
  }
  try {
    placeRobots(has_random_starts, has_random_goals, experiment);
  } catch (const std::invalid_argument& error) {
    throw yaml.error("robots", error.what());
  }
  return experiment;
}

Grid loadMapFor(const Experiment& experiment, const std::string& path) {
  const MapFile map = loadMapFile(path);
  const bool is_elsewhere = map.origin_x_m != experiment.corner.x ||
                            map.origin_y_m != experiment.corner.y || map.origin_yaw_rad != 0.0;
  if (map.cell_size_m && is_elsewhere) {
    throw fileError(path, 0,
                    "origin: must be [" + shortNumber(experiment.corner.x) + ", " +
                        shortNumber(experiment.corner.y) + ", 0] as of the experiment's map");
  }
  try {
    return inCellsOf(experiment, map);
  } catch (const std::invalid_argument& error) {
    throw fileError(path, 0,
                    "resolution: the experiment's cell_size_m " + std::string(error.what()));
  }
}

CellFrame cellFrameOf(const Experiment& experiment) {
  return {experiment.grid, experiment.cell_size_m, experiment.corner};
}

std::vector<std::string> namesOf(const Experiment& experiment) {
  std::vector<std::string> names;
  for (const RobotSpec& robot : experiment.robots) {
    names.push_back(robot.name);
  }
  return names;
}

Instance toInstance(const Experiment& experiment) {
  Instance instance;
  instance.grid = experiment.grid;
  for (const RobotSpec& robot : experiment.robots) {
    instance.starts.push_back(robot.start);
    instance.goals.push_back(robot.goal);
  }
  return instance;
}

}  // namespace sylph
