#include "sylph_adg_central/result_file.hpp"

#include <yaml-cpp/yaml.h>

#include <string>

#include "sylph_core/files/write_file.hpp"

namespace sylph_adg_central {

void writeResult(const sylph::RunResult& result, const std::string& path) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  const auto put = [&](const char* key, const auto& value) {
    yaml << YAML::Key << key << YAML::Value << value;
  };
  put("success", result.success);
  put("message", result.message);
  put("planner", result.planner);
  put("robots", result.robots);
  put("arrived", result.arrived);
  put("plan_steps", result.plan_steps);
  put("sum_of_costs", result.sum_of_costs);
  put("planning_s", result.planning_s);
  put("execution_s", result.execution_s);
  put("critical_path_cells", result.critical_path_cells);
  put("ideal_execution_s", result.ideal_execution_s);
  if (result.ideal_execution_s > 0.0) {
    put("execution_ratio", result.execution_s / result.ideal_execution_s);
  } else {
    put("execution_ratio", YAML::Null);
  }
  if (result.min_separation_m) {
    put("min_separation_m", *result.min_separation_m);
  } else {
    put("min_separation_m", YAML::Null);
  }
  put("max_tracking_error_m", result.max_tracking_error_m);
  put("replans", result.replans);
  put("stops", result.stops);
  if (result.collisions) {
    put("collisions", *result.collisions);
  }
  yaml << YAML::EndMap;
  sylph::writeFile(path, std::string(yaml.c_str()) + "\n");
}

}  // namespace sylph_adg_central
