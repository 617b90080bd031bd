#pragma once

#include <optional>
#include <string>

#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// A map as a file gives it. MovingAI maps have no size in metres.
struct MapFile {
  Grid grid;                          ///< the free cells
  std::optional<double> cell_size_m;  ///< `resolution` of a map_server map
  double origin_x_m = 0.0;            ///< `origin` of a map_server map: its lower left corner
  double origin_y_m = 0.0;            ///< likewise
  double origin_yaw_rad = 0.0;        ///< counterclockwise
};

/// Reads a map of either kind, told apart by the ending of its name:
///
/// - `.map`: MovingAI benchmark map of type octile. '.', 'G' and 'S' are free; '@', 'O', 'T' and
///   'W' are obstacles. Format: Sturtevant 2012, movingai.com/benchmarks/formats.html
/// - `.yaml`, `.yml`: ROS map_server map with a PNG or Netpbm image (P1 ... P6) of 8 or 16 bits;
///   each pixel is a cell, the first image row is row 0. Pixels that are not free (unknown, between
///   the thresholds, not opaque) are obstacles, in each of the modes trinary, scale and raw.
///   Format: wiki.ros.org/map_server
///
/// @throws std::runtime_error with one line: file, line or field, what is wrong, what is allowed
MapFile loadMapFile(const std::string& path);

/// The grid of loadMapFile().
Grid loadMap(const std::string& path);

/// Writes a MovingAI map, '.' free and '@' obstacle.
/// @throws std::runtime_error naming the file if it cannot be written
void saveMap(const Grid& grid, const std::string& path);

}  // namespace sylph
