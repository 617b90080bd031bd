#include "sylph_training/worlds/world_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sylph_core/grid/generators.hpp"
#include "sylph_core/mapf/random_instance.hpp"

namespace sylph_training {
namespace {

double draw(const Interval& interval, sylph::Rng& rng) {
  return interval.lowest + (interval.highest - interval.lowest) * sylph::drawFraction(rng);
}

int drawWhole(const Interval& interval, sylph::Rng& rng) {
  const auto count = static_cast<std::size_t>(interval.highest - interval.lowest) + 1;
  return static_cast<int>(interval.lowest) + static_cast<int>(sylph::drawIndex(rng, count));
}

void readInterval(const sylph::YamlMap& yaml, const std::string& key, const sylph::Range& range,
                  Interval& interval) {
  if (yaml.has(key)) {
    const std::vector<double> bounds = yaml.numbers(key, 2, range);
    if (bounds[0] > bounds[1]) {
      throw yaml.error(key, "must be [lowest, highest]");
    }
    interval = {bounds[0], bounds[1]};
  }
}

void readWholeInterval(const sylph::YamlMap& yaml, const std::string& key,
                       const sylph::Range& range, Interval& interval) {
  readInterval(yaml, key, range, interval);
  if (interval.lowest != std::floor(interval.lowest) ||
      interval.highest != std::floor(interval.highest)) {
    throw yaml.error(key, "must be whole numbers");
  }
}

void readFamily(const sylph::YamlMap& yaml, FamilySettings& family) {
  family.weight = yaml.number("weight", family.weight, sylph::Range::atLeast(0.0));
  readInterval(yaml, "team_share", {0.0, 1.0, true}, family.team_share);
}

}  // namespace

WorldSettings WorldSettings::read(const sylph::YamlMap& yaml) {
  WorldSettings settings;
  const sylph::Range share{0.0, 1.0};
  const sylph::Range sides{3.0, 256.0};
  readWholeInterval(yaml, "side", sides, settings.side);
  readWholeInterval(yaml, "usual_side", sides, settings.usual_side);
  settings.usual_share = yaml.number("usual_share", settings.usual_share, share);
  settings.most_agents =
      static_cast<int>(yaml.integer("most_agents", settings.most_agents, 1, 10000));
  settings.motion.rotations = yaml.boolean("rotations", settings.motion.rotations);
  if (const auto random = yaml.map("random")) {
    readFamily(*random, settings.random);
    readInterval(*random, "density", {0.0, 0.9}, settings.density);
    random->refuseUnread();
  }
  if (const auto room = yaml.map("room")) {
    readFamily(*room, settings.room);
    readWholeInterval(*room, "room_size", {1.0, 64.0}, settings.room_size);
    readInterval(*room, "door_share", share, settings.door_share);
    room->refuseUnread();
  }
  if (const auto maze = yaml.map("maze")) {
    readFamily(*maze, settings.maze);
    readInterval(*maze, "opened_share", share, settings.opened_share);
    maze->refuseUnread();
  }
  if (settings.random.weight + settings.room.weight + settings.maze.weight <= 0.0) {
    throw yaml.error("random", "one of the families random, room, maze needs a weight > 0");
  }
  yaml.refuseUnread();
  return settings;
}

sylph::Instance sampleWorld(const WorldSettings& settings, sylph::Rng& rng) {
  const bool is_usual = sylph::drawFraction(rng) < settings.usual_share;
  const int side = drawWhole(is_usual ? settings.usual_side : settings.side, rng);
  const std::array<double, 3> weights = {settings.random.weight, settings.room.weight,
                                         settings.maze.weight};
  const std::size_t family =
      sylph::drawByWeight(rng, weights.size(), [&](std::size_t index) { return weights[index]; });
  sylph::Grid grid;
  Interval team_share{};
  if (family == 0) {
    grid = sylph::randomMap({side, side, draw(settings.density, rng)}, rng);
    team_share = settings.random.team_share;
  } else if (family == 1) {
    const int room_size = drawWhole(settings.room_size, rng);
    grid = sylph::roomMap({side, side, room_size, 1, draw(settings.door_share, rng)}, rng);
    team_share = settings.room.team_share;
  } else {
    grid = sylph::mazeMap({side, side, 1, draw(settings.opened_share, rng)}, rng);
    team_share = settings.maze.team_share;
  }
  const auto wanted = static_cast<int>(std::lround(draw(team_share, rng) * grid.freeCellCount()));
  const int agents = std::clamp(wanted, 1, std::min(settings.most_agents, grid.freeCellCount()));
  return sylph::randomInstance(grid, agents, settings.motion, rng);
}

}  // namespace sylph_training
