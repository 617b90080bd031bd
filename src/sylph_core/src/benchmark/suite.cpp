#include "sylph_core/benchmark/suite.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "files/text_file.hpp"
#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/mapf/scenario_file.hpp"

namespace sylph {
namespace {

constexpr int kMostInstances = 100000;
constexpr int kMostAgents = 1000000;

int readInt(const YamlMap& yaml, const std::string& key, int otherwise, int lowest, int highest) {
  return static_cast<int>(yaml.integer(key, otherwise, lowest, highest));
}

template <typename Spec>
Spec readSides(const YamlMap& yaml) {
  Spec spec;
  spec.rows = readInt(yaml, "rows", spec.rows, 1, Grid::kMaxSide);
  spec.cols = readInt(yaml, "cols", spec.cols, 1, Grid::kMaxSide);
  return spec;
}

std::variant<RandomMapSpec, RoomMapSpec, MazeMapSpec> readGenerator(const YamlMap& yaml) {
  const std::string kind = yaml.word("generator", {"random", "room", "maze"}, "random");
  if (kind == "random") {
    auto spec = readSides<RandomMapSpec>(yaml);
    spec.density = yaml.number("density", spec.density, {0.0, 0.99});
    return spec;
  }
  if (kind == "room") {
    auto spec = readSides<RoomMapSpec>(yaml);
    spec.room_size = readInt(yaml, "room_size", spec.room_size, 1, Grid::kMaxSide);
    spec.door_width = readInt(yaml, "door_width", spec.door_width, 1, spec.room_size);
    spec.door_share = yaml.number("door_share", spec.door_share, {0.0, 1.0});
    return spec;
  }
  auto spec = readSides<MazeMapSpec>(yaml);
  spec.corridor_width = readInt(yaml, "corridor_width", spec.corridor_width, 1, Grid::kMaxSide);
  spec.opened_share = yaml.number("opened_share", spec.opened_share, {0.0, 1.0});
  return spec;
}

BenchmarkFamily readFamily(const YamlMap& yaml) {
  BenchmarkFamily family;
  family.name = yaml.text("name");
  family.agents = yaml.integers("agents", 1, kMostAgents);
  if (yaml.has("generator") == yaml.has("map")) {
    throw yaml.error(yaml.has("map") ? "map" : "generator",
                     "a family needs either 'generator' or 'map'");
  }
  if (yaml.has("generator")) {
    GeneratedInstances generated;
    generated.map = readGenerator(yaml);
    generated.instances = readInt(yaml, "instances", generated.instances, 1, kMostInstances);
    generated.seed = static_cast<std::uint32_t>(
        yaml.integer("seed", 0, 0, std::numeric_limits<std::uint32_t>::max()));
    family.source = generated;
  } else {
    StoredInstances stored;
    stored.map_path = resolvePath(yaml.path(), yaml.text("map"));
    for (const std::string& scenario : yaml.texts("scenarios")) {
      stored.scenario_paths.push_back(resolvePath(yaml.path(), scenario));
    }
    family.source = stored;
  }
  yaml.refuseUnread();
  return family;
}

/// @param names  of those that are there already
ExternalSolver readSolver(const YamlMap& yaml, const std::set<std::string>& names) {
  static const std::map<std::string, PlanFormat> kFormats = {
      {"sylph", PlanFormat::Sylph}, {"lacam", PlanFormat::Lacam}, {"paths", PlanFormat::Paths}};
  ExternalSolver solver;
  solver.name = yaml.text("name");
  if (names.count(solver.name) > 0) {
    throw yaml.error("name", inQuotes(solver.name) + " is another planner's or solver's too");
  }
  if (solver.name.find_first_of(",\"\r\n") != std::string::npos) {
    throw yaml.error("name", inQuotes(solver.name) + " must have no comma, quote or line end");
  }
  try {
    solver.command = splitCommand(yaml.text("command"));
  } catch (const std::invalid_argument& error) {
    throw yaml.error("command", error.what());
  }
  solver.source = yaml.error("command", "").what();
  solver.plan_format = kFormats.at(yaml.word("plan_format", {"sylph", "lacam", "paths"}, "sylph"));
  solver.grace_s = yaml.number("grace_s", solver.grace_s, Range::positive());
  solver.folder = resolvePath(yaml.path(), "");
  yaml.refuseUnread();
  return solver;
}

std::vector<Instance> makeInstances(const GeneratedInstances& generated, int agents,
                                    const MotionModel& motion) {
  struct Generator {
    Rng& rng;
    Grid operator()(const RandomMapSpec& spec) const { return randomMap(spec, rng); }
    Grid operator()(const RoomMapSpec& spec) const { return roomMap(spec, rng); }
    Grid operator()(const MazeMapSpec& spec) const { return mazeMap(spec, rng); }
  };
  std::vector<Instance> instances;
  for (int number = 0; number < generated.instances; ++number) {
    Rng rng(generated.seed + static_cast<std::uint32_t>(number));
    instances.push_back(
        randomInstance(std::visit(Generator{rng}, generated.map), agents, motion, rng));
  }
  return instances;
}

std::vector<Instance> makeInstances(const StoredInstances& stored, int agents,
                                    const MotionModel& motion) {
  const Grid grid = loadMap(stored.map_path);
  std::vector<Instance> instances;
  for (const std::string& path : stored.scenario_paths) {
    instances.push_back(loadScenario(path, grid, agents, motion));
  }
  return instances;
}

Instance firstAgents(Instance instance, int agents) {
  instance.starts.resize(static_cast<std::size_t>(agents));
  instance.goals.resize(static_cast<std::size_t>(agents));
  return instance;
}

}  // namespace

BenchmarkSuite loadSuite(const std::string& path) {
  const YamlMap yaml = YamlMap::load(path);
  BenchmarkSuite suite;
  suite.planners = {plannerNames().front()};
  if (yaml.has("planners")) {
    suite.planners = yaml.words("planners", plannerNames());
  }
  if (yaml.has("ablations")) {
    suite.ablations = yaml.words("ablations", ablationNames());
  }
  suite.limits.time_limit_s =
      yaml.number("time_limit_s", suite.limits.time_limit_s, Range::positive());
  suite.limits.max_steps =
      readInt(yaml, "max_steps", suite.limits.max_steps, 1, std::numeric_limits<int>::max());
  suite.limits.first_solution_only = yaml.boolean("first", false);
  suite.motion.rotations = yaml.boolean("rotations", false);
  if (yaml.has("external")) {
    std::set<std::string> taken(plannerNames().begin(), plannerNames().end());
    for (const YamlMap& entry : yaml.maps("external")) {
      suite.external.push_back(readSolver(entry, taken));
      taken.insert(suite.external.back().name);
    }
  }
  std::set<std::string> names;
  for (const YamlMap& entry : yaml.maps("families")) {
    suite.families.push_back(readFamily(entry));
    if (!names.insert(suite.families.back().name).second) {
      throw entry.error("name", inQuotes(suite.families.back().name) + " is another family's too");
    }
  }
  yaml.refuseUnread();
  return suite;
}

std::size_t entrantCount(const BenchmarkSuite& suite) {
  const auto guided = static_cast<std::size_t>(
      std::count_if(suite.planners.begin(), suite.planners.end(), needsPolicy));
  return suite.planners.size() + guided * suite.ablations.size() + suite.external.size();
}

std::vector<BenchmarkCase> makeCases(const BenchmarkSuite& suite) {
  std::vector<BenchmarkCase> cases;
  for (const BenchmarkFamily& family : suite.families) {
    const int most = *std::max_element(family.agents.begin(), family.agents.end());
    std::vector<Instance> instances;
    try {
      instances =
          std::visit([&](const auto& source) { return makeInstances(source, most, suite.motion); },
                     family.source);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("family " + inQuotes(family.name) + ": " + error.what());
    }
    for (std::size_t number = 0; number < instances.size(); ++number) {
      for (const int agents : family.agents) {
        cases.push_back({family.name, static_cast<int>(number), static_cast<std::uint32_t>(number),
                         firstAgents(instances[number], agents)});
      }
    }
  }
  return cases;
}

}  // namespace sylph
