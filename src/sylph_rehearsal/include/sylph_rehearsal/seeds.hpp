#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "sylph_core/experiment/experiment.hpp"

namespace sylph_rehearsal {

/// Seeds of runs, both ends included.
struct SeedRange {
  std::uint32_t first = 0;  ///< included
  std::uint32_t last = 0;   ///< included
  /// At least 1.
  std::size_t count() const { return std::size_t{last} - first + 1; }
};

/// "A-B" or "A".
/// @throws std::invalid_argument with one line if it is neither, or A is greater than B
SeedRange seedsFromText(const std::string& text);

/// An experiment with another seed and so many robots: its first ones; or, if it has fewer, robots
/// like its last one, called robot_0, robot_1, ..., whose starts and goals are all drawn from the
/// seed.
/// @param robots  0: as many as it has
/// @throws std::runtime_error as loadExperiment()
/// @throws std::invalid_argument if the map has no room for them
sylph::Experiment experimentOf(const std::string& path, std::uint32_t seed, int robots);

}  // namespace sylph_rehearsal
