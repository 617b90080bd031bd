#pragma once

#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/scenario_file.hpp"

namespace sylph {

/// The instance that a command works on.
struct InstanceOptions {
  std::string map_path;
  std::string scenario_path;
  int agents = 0;
  bool rotations = false;

  Instance load() const {
    return loadScenario(scenario_path, loadMap(map_path), agents, MotionModel{rotations});
  }
};

inline void addInstanceOptions(CLI::App& app, InstanceOptions& options) {
  app.add_option("--map", options.map_path, "MovingAI .map or map_server .yaml")->required();
  app.add_option("--scen", options.scenario_path, "MovingAI .scen")->required();
  app.add_option("--agents", options.agents, "the first N of the scenario")
      ->required()
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  app.add_flag("--rotations", options.rotations, "agents may rotate in one timestep");
}

}  // namespace sylph
