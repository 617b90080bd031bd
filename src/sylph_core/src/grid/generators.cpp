#include "sylph_core/grid/generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace sylph {
namespace {

void requireShare(double share, const char* name) {
  if (!(share >= 0.0 && share <= 1.0)) {
    throw std::invalid_argument(std::string(name) + " " + std::to_string(share) +
                                ": must be 0 ... 1");
  }
}

void requireWithin(int value, int lowest, int highest, const char* name) {
  if (value < lowest || value > highest) {
    throw std::invalid_argument(std::string(name) + " " + std::to_string(value) + ": must be " +
                                std::to_string(lowest) + " ... " + std::to_string(highest));
  }
}

/// Sets obstacles one by one and refuses those that would cut the free cells in two.
///
/// Free cells (4-connected) fall apart exactly when obstacles (8-connected, the outside included)
/// close a ring. So a union of touching obstacles tells, without any search.
class ConnectedObstacles {
 public:
  explicit ConnectedObstacles(Grid& grid)
      : grid_(grid), parent_(static_cast<std::size_t>(grid.size()) + 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// @return whether the cell became an obstacle
  bool tryAdd(const Cell& cell) {
    const std::array<Cell, 8> ring = ringAround(cell);
    if (wouldCut(ring)) {
      return false;
    }
    for (const Cell& touching : ring) {
      if (!grid_.isFree(touching)) {
        parent_[find(node(touching))] = find(node(cell));
      }
    }
    grid_.setObstacle(cell);
    return true;
  }

 private:
  /// The eight cells around, in order, edges (even places) and corners (odd places) in turn.
  static std::array<Cell, 8> ringAround(const Cell& cell) {
    const auto [row, col] = cell;
    return {Cell{row - 1, col}, Cell{row - 1, col + 1}, Cell{row, col + 1}, Cell{row + 1, col + 1},
            Cell{row + 1, col}, Cell{row + 1, col - 1}, Cell{row, col - 1}, Cell{row - 1, col - 1}};
  }

  std::size_t node(const Cell& cell) const {
    return grid_.isInside(cell) ? static_cast<std::size_t>(grid_.indexOf(cell))
                                : parent_.size() - 1;
  }

  std::size_t find(std::size_t element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  /// Between two free edges of the ring that follow each other, all obstacles touch. Two such gaps
  /// of one body of obstacles would close a ring around the free edge between them.
  bool wouldCut(const std::array<Cell, 8>& ring) {
    std::size_t first = 0;
    while (first < ring.size() && !grid_.isFree(ring[first])) {
      first += 2;
    }
    if (first >= ring.size()) {
      return false;  // no free neighbour: only the last free cell of a map, which the caller keeps
    }
    std::vector<std::size_t> bodies;  // one per gap with obstacles
    bool is_new_gap = true;
    for (std::size_t step = 1; step < ring.size(); ++step) {
      const std::size_t place = (first + step) % ring.size();
      if (!grid_.isFree(ring[place])) {
        if (is_new_gap) {
          bodies.push_back(find(node(ring[place])));
        }
        is_new_gap = false;
      } else if (place % 2 == 0) {
        is_new_gap = true;
      }
    }
    std::sort(bodies.begin(), bodies.end());
    return std::adjacent_find(bodies.begin(), bodies.end()) != bodies.end();
  }

  Grid& grid_;
  std::vector<std::size_t> parent_;  // per cell, then one for the outside
};

/// Squares of `room_size` cells, `room_size + 1` apart, on a map that is wall elsewhere.
class RoomLattice {
 public:
  using Room = std::pair<int, int>;  // row and column in the lattice
  struct Wall {
    Room room;
    Room next;  // the room to the east or to the south of it
  };

  RoomLattice(int rows, int cols, int room_size) : grid_(rows, cols), room_size_(room_size) {
    for (int index = 0; index < grid_.size(); ++index) {
      const Cell cell = grid_.cellAt(index);
      grid_.setObstacle(cell, cell.row % period() == room_size || cell.col % period() == room_size);
    }
  }

  /// Opens `width` cells, or all if there are fewer, at a random place of the wall.
  void open(const Wall& wall, int width, Rng& rng) {
    const bool is_east = wall.next.second > wall.room.second;
    const int first = (is_east ? wall.room.first : wall.room.second) * period();
    const int side = is_east ? grid_.rows() : grid_.cols();
    const int length = std::min(room_size_, side - first);
    const int opened = std::min(width, length);
    const int door =
        first + static_cast<int>(drawIndex(rng, static_cast<std::size_t>(length - opened) + 1));
    const int across = (is_east ? wall.next.second : wall.next.first) * period() - 1;
    for (int along = door; along < door + opened; ++along) {
      grid_.setObstacle(is_east ? Cell{along, across} : Cell{across, along}, false);
    }
  }

  /// Splits all walls into those that a random depth-first walk through the rooms opens, which
  /// connect every room without a loop, and the others.
  std::pair<std::vector<Wall>, std::vector<Wall>> splitWalls(Rng& rng) const {
    std::vector<Wall> tree;
    std::vector<Wall> others;
    std::vector<bool> visited(indexOf(Room{roomRows(), 0}), false);
    std::vector<bool> is_tree(2 * visited.size(), false);
    std::vector<Room> trail = {{0, 0}};
    visited[0] = true;
    while (!trail.empty()) {
      std::vector<Room> unvisited;
      for (const Room& room : neighborsOf(trail.back())) {
        if (!visited[indexOf(room)]) {
          unvisited.push_back(room);
        }
      }
      if (unvisited.empty()) {
        trail.pop_back();
        continue;
      }
      const Room next = unvisited[drawIndex(rng, unvisited.size())];
      const Wall wall = {std::min(trail.back(), next), std::max(trail.back(), next)};
      tree.push_back(wall);
      is_tree[indexOf(wall)] = true;
      visited[indexOf(next)] = true;
      trail.push_back(next);
    }
    for (int index = 0; index < roomRows() * roomCols(); ++index) {
      const Room room = {index / roomCols(), index % roomCols()};
      for (const Room& next : neighborsOf(room)) {
        if (room < next && !is_tree[indexOf(Wall{room, next})]) {
          others.push_back({room, next});
        }
      }
    }
    return {tree, others};
  }

  const Grid& grid() const { return grid_; }

 private:
  int period() const { return room_size_ + 1; }
  int roomRows() const { return (grid_.rows() + period() - 1) / period(); }
  int roomCols() const { return (grid_.cols() + period() - 1) / period(); }
  std::size_t indexOf(const Room& room) const {
    return static_cast<std::size_t>(room.first) * static_cast<std::size_t>(roomCols()) +
           static_cast<std::size_t>(room.second);
  }
  std::size_t indexOf(const Wall& wall) const {
    return 2 * indexOf(wall.room) + (wall.next.first > wall.room.first ? 1 : 0);
  }
  std::vector<Room> neighborsOf(const Room& room) const {
    const auto [row, col] = room;
    std::vector<Room> neighbors;
    for (const Room& next :
         {Room{row - 1, col}, Room{row, col + 1}, Room{row + 1, col}, Room{row, col - 1}}) {
      if (next.first >= 0 && next.first < roomRows() && next.second >= 0 &&
          next.second < roomCols()) {
        neighbors.push_back(next);
      }
    }
    return neighbors;
  }

  Grid grid_;
  int room_size_;
};

/// Opens every wall of the tree and a share of the others, exactly rounded.
Grid openWalls(RoomLattice lattice, int width, double share, Rng& rng) {
  auto [tree, others] = lattice.splitWalls(rng);
  shuffle(others, rng);
  others.resize(static_cast<std::size_t>(std::lround(share * static_cast<double>(others.size()))));
  for (const auto& walls : {tree, others}) {
    for (const RoomLattice::Wall& wall : walls) {
      lattice.open(wall, width, rng);
    }
  }
  return lattice.grid();
}

}  // namespace

Grid randomMap(const RandomMapSpec& spec, Rng& rng) {
  if (!(spec.density >= 0.0 && spec.density < 1.0)) {
    throw std::invalid_argument("density " + std::to_string(spec.density) +
                                ": must be >= 0 and < 1");
  }
  Grid grid(spec.rows, spec.cols);
  const auto wanted = std::min<long>(std::lround(spec.density * grid.size()), grid.size() - 1);
  ConnectedObstacles obstacles(grid);
  std::vector<Cell> candidates = grid.freeCells();
  shuffle(candidates, rng);
  // A cell refused once may be taken later, for instance as the end of a dead end. Any connected
  // graph has a vertex that does not cut it, so each round sets at least one.
  for (long placed = 0; placed < wanted;) {
    std::vector<Cell> refused;
    for (const Cell& cell : candidates) {
      if (placed < wanted && obstacles.tryAdd(cell)) {
        ++placed;
      } else {
        refused.push_back(cell);
      }
    }
    candidates = std::move(refused);
  }
  return grid;
}

Grid roomMap(const RoomMapSpec& spec, Rng& rng) {
  requireWithin(spec.room_size, 1, Grid::kMaxSide, "room_size");
  requireWithin(spec.door_width, 1, spec.room_size, "door_width");
  requireShare(spec.door_share, "door_share");
  return openWalls(RoomLattice(spec.rows, spec.cols, spec.room_size), spec.door_width,
                   spec.door_share, rng);
}

Grid mazeMap(const MazeMapSpec& spec, Rng& rng) {
  requireWithin(spec.corridor_width, 1, Grid::kMaxSide, "corridor_width");
  requireShare(spec.opened_share, "opened_share");
  return openWalls(RoomLattice(spec.rows, spec.cols, spec.corridor_width), spec.corridor_width,
                   spec.opened_share, rng);
}

}  // namespace sylph
