// sylph_generate_map: writes a random, room-like or maze map, and a scenario for it if asked to.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include "sylph_core/command/run_command.hpp"
#include "sylph_core/grid/generators.hpp"
#include "sylph_core/grid/map_file.hpp"
#include "sylph_core/mapf/random_instance.hpp"
#include "sylph_core/mapf/scenario_file.hpp"

namespace {

struct Options {
  int rows = 32;
  int cols = 32;
  std::uint32_t seed = 0;
  std::string map_path;
  std::string scenario_path;
  int agents = 0;
  sylph::RandomMapSpec random;
  sylph::RoomMapSpec room;
  sylph::MazeMapSpec maze;
};

int generate(const std::string& family, Options options) {
  sylph::Rng rng(options.seed);
  const auto sized = [&](auto spec) {
    spec.rows = options.rows;
    spec.cols = options.cols;
    return spec;
  };
  const sylph::Grid grid = family == "random" ? sylph::randomMap(sized(options.random), rng)
                           : family == "room" ? sylph::roomMap(sized(options.room), rng)
                                              : sylph::mazeMap(sized(options.maze), rng);
  std::optional<sylph::Instance> instance;
  if (!options.scenario_path.empty()) {
    instance = sylph::randomInstance(grid, options.agents, {}, rng);
  }
  sylph::saveMap(grid, options.map_path);
  const int blocked = grid.size() - grid.freeCellCount();
  std::cout << options.map_path << ": " << grid.rows() << " x " << grid.cols() << " cells, "
            << 100.0 * blocked / grid.size() << " % blocked\n";
  if (instance) {
    sylph::saveScenario(*instance, options.map_path, options.scenario_path);
    std::cout << options.scenario_path << ": " << options.agents << " agents\n";
  }
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Generates a map whose free cells are connected, and a scenario for it.",
               "sylph_generate_map");
  app.require_subcommand(1);
  app.fallthrough();  // the options of all families may follow the family's name
  Options options;
  app.add_option("--rows", options.rows, "cells from top to bottom")->capture_default_str();
  app.add_option("--cols", options.cols, "cells from left to right")->capture_default_str();
  app.add_option("--seed", options.seed, "the same seed gives the same map")->capture_default_str();
  app.add_option("--out", options.map_path, "MovingAI .map file to write")->required();
  auto* scenario = app.add_option("--scen", options.scenario_path, "MovingAI .scen file to write");
  app.add_option("--agents", options.agents, "agents of the scenario")->needs(scenario);

  auto* random = app.add_subcommand("random", "scattered obstacles");
  random->add_option("--density", options.random.density, "share of obstacles")
      ->capture_default_str();
  auto* room = app.add_subcommand("room", "square rooms with doors");
  room->add_option("--room-size", options.room.room_size, "[cells]")->capture_default_str();
  room->add_option("--door-width", options.room.door_width, "[cells]")->capture_default_str();
  room->add_option("--door-share", options.room.door_share,
                   "of the walls that need no door to connect the rooms")
      ->capture_default_str();
  auto* maze = app.add_subcommand("maze", "corridors");
  maze->add_option("--corridor-width", options.maze.corridor_width, "[cells]")
      ->capture_default_str();
  maze->add_option("--opened-share", options.maze.opened_share,
                   "of the walls left by a maze without loops")
      ->capture_default_str();
  return sylph::runCommand(app, argc, argv, [&] {
    return generate(app.get_subcommands().front()->get_name(), options);
  });
}
