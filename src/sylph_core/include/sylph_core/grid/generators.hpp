#pragma once

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/grid/rng.hpp"

namespace sylph {

// Maps for tests, training and benchmarks. In each of them the free cells are connected, and the
// same specification and generator state give the same map.

/// Obstacles scattered over the map.
struct RandomMapSpec {
  int rows = 32;         ///< 1 ... Grid::kMaxSide
  int cols = 32;         ///< 1 ... Grid::kMaxSide
  double density = 0.2;  ///< share of obstacles, 0 <= density < 1; one cell always stays free
};

/// Square rooms, separated by walls of one cell with a door in most of them.
struct RoomMapSpec {
  int rows = 32;            ///< 1 ... Grid::kMaxSide
  int cols = 32;            ///< 1 ... Grid::kMaxSide
  int room_size = 3;        ///< side of a room [cells], > 0; rooms at the far edges may be smaller
  int door_width = 1;       ///< [cells], 1 ... room_size
  double door_share = 0.9;  ///< of the walls that need no door to connect the rooms, 0 ... 1
};

/// Corridors between walls of one cell.
struct MazeMapSpec {
  int rows = 32;              ///< 1 ... Grid::kMaxSide
  int cols = 32;              ///< 1 ... Grid::kMaxSide
  int corridor_width = 1;     ///< [cells], > 0; corridors at the far edges may be narrower
  double opened_share = 0.1;  ///< of the walls left by a maze without loops, 0 ... 1
};

/// Exactly round(density * rows * cols) obstacles, each drawn among the cells that do not cut the
/// free cells in two.
/// @throws std::invalid_argument naming the member that is out of its range
Grid randomMap(const RandomMapSpec& spec, Rng& rng);

/// @throws std::invalid_argument naming the member that is out of its range
Grid roomMap(const RoomMapSpec& spec, Rng& rng);

/// @throws std::invalid_argument naming the member that is out of its range
Grid mazeMap(const MazeMapSpec& spec, Rng& rng);

}  // namespace sylph
