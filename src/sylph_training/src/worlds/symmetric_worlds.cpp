#include "sylph_training/worlds/symmetric_worlds.hpp"

#include <stdexcept>
#include <string>

namespace sylph_training {
namespace {

void requireInRange(const char* name, int value, int lowest, int highest) {
  if (value < lowest || value > highest) {
    throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + ": must be " +
                                std::to_string(lowest) + " ... " + std::to_string(highest));
  }
}

constexpr int kLongest = 64;

// Three rows, the corridor in the middle one.
sylph::Instance corridor(int length) {
  sylph::Instance world;
  world.grid = sylph::Grid(3, length);
  for (int col = 0; col < length; ++col) {
    world.grid.setObstacle({0, col});
    world.grid.setObstacle({2, col});
  }
  world.starts = {{1, 0}, {1, length - 1}};
  world.goals = {{1, length - 1}, {1, 0}};
  return world;
}

}  // namespace

void SymmetricWorldSpec::requireValid() const {
  if (!(recess_share >= 0.0 && recess_share <= 1.0)) {
    throw std::invalid_argument("recess_share = " + std::to_string(recess_share) +
                                ": must be 0 ... 1");
  }
  requireInRange("min_length", min_length, 5, kLongest);
  requireInRange("max_length", max_length, min_length, kLongest);
}

sylph::Instance recessWorld(int length, int recess_cell) {
  requireInRange("length", length, 5, kLongest);
  requireInRange("recess_cell", recess_cell, 1, (length - 1) / 2);
  sylph::Instance world = corridor(length);
  world.grid.setObstacle({0, recess_cell}, false);
  world.grid.setObstacle({2, length - 1 - recess_cell}, false);
  return world;
}

sylph::Instance iShapedWorld(int length) {
  requireInRange("length", length, 3, kLongest);
  sylph::Instance world = corridor(length);
  for (const int row : {0, 2}) {
    world.grid.setObstacle({row, 0}, false);
    world.grid.setObstacle({row, length - 1}, false);
  }
  return world;
}

sylph::Instance symmetricWorld(const SymmetricWorldSpec& spec, sylph::Rng& rng) {
  spec.requireValid();
  const bool has_recesses = sylph::drawFraction(rng) < spec.recess_share;
  const auto draw = [&](int lowest, int highest) {
    return lowest +
           static_cast<int>(sylph::drawIndex(rng, static_cast<std::size_t>(highest - lowest + 1)));
  };
  const int length = draw(spec.min_length, spec.max_length);
  return has_recesses ? recessWorld(length, draw(1, (length - 1) / 2)) : iShapedWorld(length);
}

}  // namespace sylph_training
