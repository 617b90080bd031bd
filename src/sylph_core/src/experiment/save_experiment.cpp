#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "experiment/execution_members.hpp"
#include "files/text_file.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/files/write_file.hpp"

namespace sylph {
namespace {

/// The shortest text that reads as exactly this number.
std::string exactNumber(double value) {
  char text[40];
  for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) {
      break;
    }
  }
  return text;
}

/// A file as another one names it: by its name alone where both lie in one folder.
std::string nameFrom(const std::string& naming_file, const std::string& named_file) {
  const auto file = std::filesystem::absolute(named_file);
  const auto folder = std::filesystem::absolute(naming_file).parent_path();
  std::error_code error;
  // So that a folder with map and experiment can be moved.
  return std::filesystem::equivalent(folder, file.parent_path(), error) ? file.filename().string()
                                                                        : file.string();
}

void write(YAML::Emitter& yaml, const char* key, const Cell& cell) {
  yaml << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq << cell.row << cell.col
       << YAML::EndSeq;
}

void write(YAML::Emitter& yaml, const RobotSpec& robot) {
  yaml << YAML::Flow << YAML::BeginMap << YAML::Key << "name" << YAML::Value << robot.name;
  yaml << YAML::Key << "rigid_body" << YAML::Value << YAML::DoubleQuoted << robot.rigid_body;
  yaml << YAML::Key << "footprint_m" << YAML::Value << YAML::BeginSeq << exactNumber(robot.length_m)
       << exactNumber(robot.width_m) << YAML::EndSeq;
  write(yaml, "start", robot.start);
  write(yaml, "goal", robot.goal);
  yaml << YAML::EndMap;
}

void write(YAML::Emitter& yaml, const PlanningSpec& planning, const std::string& path) {
  yaml << YAML::BeginMap << YAML::Key << "planner" << YAML::Value << planning.planner;
  if (!planning.weights_path.empty()) {
    yaml << YAML::Key << "weights" << YAML::Value << YAML::DoubleQuoted
         << nameFrom(path, planning.weights_path);
  }
  yaml << YAML::Key << "time_limit_s" << YAML::Value << exactNumber(planning.time_limit_s)
       << YAML::EndMap;
}

void write(YAML::Emitter& yaml, const ExecutionSpec& execution) {
  yaml << YAML::BeginMap;
  for (const ExecutionMember& member : kExecutionMembers) {
    yaml << YAML::Key << member.key << YAML::Value << exactNumber(execution.*member.value);
  }
  yaml << YAML::EndMap;
}

}  // namespace

void saveExperiment(const Experiment& experiment, const std::string& path) {
  if (std::filesystem::exists(path)) {
    throw fileError(path, 0, "is there already: choose another name or remove it");
  }
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "map" << YAML::Value << YAML::DoubleQuoted
       << nameFrom(path, experiment.map_path);
  yaml << YAML::Key << "cell_size_m" << YAML::Value << exactNumber(experiment.cell_size_m);
  yaml << YAML::Key << "seed" << YAML::Value << experiment.seed;
  yaml << YAML::Key << "robots" << YAML::Value << YAML::BeginSeq;
  for (const RobotSpec& robot : experiment.robots) {
    write(yaml, robot);
  }
  yaml << YAML::EndSeq << YAML::Key << "planning" << YAML::Value;
  write(yaml, experiment.planning, path);
  yaml << YAML::Key << "execution" << YAML::Value;
  write(yaml, experiment.execution);
  yaml << YAML::EndMap;
  writeFile(path, std::string(yaml.c_str()) + "\n");
}

}  // namespace sylph
