#pragma once

#include <string>

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/instance.hpp"

namespace sylph {

/// Reads the first `agents` agents of a MovingAI scenario: a line "version 1", then one line per
/// agent with nine fields, bucket, map, map width, map height, start x, start y, goal x, goal y and
/// optimal length, where x is the column and y the row from the top.
///
/// The map's name in the file is not looked at; its width and height are those of `grid`. Starts
/// and goals satisfy requireValid(). Format: Sturtevant 2012, movingai.com/benchmarks/formats.html
///
/// @throws std::runtime_error with one line: file, line, what is wrong, what is allowed
Instance loadScenario(const std::string& path, const Grid& grid, int agents,
                      const MotionModel& motion = {});

/// Writes an instance as a MovingAI scenario.
/// @param map_path  of the instance's map; its last component is written
/// @throws std::runtime_error naming the file if it cannot be written
void saveScenario(const Instance& instance, const std::string& map_path, const std::string& path);

}  // namespace sylph
