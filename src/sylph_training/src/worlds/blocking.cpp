#include "sylph_training/worlds/blocking.hpp"

#include <array>
#include <deque>
#include <limits>
#include <stdexcept>
#include <string>

#include "sylph_core/policy/observation.hpp"

namespace sylph_training {
namespace {

using sylph::AgentId;
using sylph::Cell;

constexpr int kHalfView = sylph::kFieldOfView / 2;
constexpr int kNoPath = -1;
constexpr int kAnyLength = std::numeric_limits<int>::max();
/// From one side of a cell to the next by the long way round it takes six moves instead of two.
constexpr int kLongestWayRound = 4;

}  // namespace

BlockingTest::BlockingTest(const sylph::Grid& grid,
                           const std::vector<sylph::DistanceField>& distances, int detour_cells)
    : grid_(grid),
      distances_(distances),
      detour_cells_(detour_cells),
      occupant_(static_cast<std::size_t>(grid.size()), -1),
      is_taken_(occupant_.size(), 0),
      reached_(occupant_.size(), 0) {
  if (detour_cells < 0) {
    throw std::invalid_argument("detour_cells = " + std::to_string(detour_cells) +
                                ": must be >= 0");
  }
}

std::vector<int> BlockingTest::count(const sylph::Configuration& cells) {
  const auto indexOf = [&](std::size_t agent) {
    return static_cast<std::size_t>(grid_.indexOf(cells[agent]));
  };
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    occupant_[indexOf(agent)] = static_cast<AgentId>(agent);
  }
  std::vector<int> blocked(cells.size(), 0);
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    if (cells[agent] == distances_[agent].goal()) {
      blocked[agent] = countBlockedBy(static_cast<AgentId>(agent), cells);
    }
  }
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    occupant_[indexOf(agent)] = -1;
  }
  return blocked;
}

int BlockingTest::countBlockedBy(AgentId agent, const sylph::Configuration& cells) {
  const Cell center = cells[static_cast<std::size_t>(agent)];
  std::vector<AgentId> in_view;
  for (int row = center.row - kHalfView; row <= center.row + kHalfView; ++row) {
    for (int col = center.col - kHalfView; col <= center.col + kHalfView; ++col) {
      const Cell cell{row, col};
      if (cell == center || !grid_.isInside(cell)) {
        continue;
      }
      const auto index = static_cast<std::size_t>(grid_.indexOf(cell));
      if (occupant_[index] >= 0) {
        in_view.push_back(occupant_[index]);
        is_taken_[index] = 1;
      }
    }
  }
  int blocked = 0;
  for (const AgentId other : in_view) {
    blocked += isBlocked(other, agent, cells) ? 1 : 0;
  }
  for (const AgentId other : in_view) {
    is_taken_[static_cast<std::size_t>(grid_.indexOf(cells[static_cast<std::size_t>(other)]))] = 0;
  }
  return blocked;
}

bool BlockingTest::isBlocked(AgentId agent, AgentId by, const sylph::Configuration& cells) {
  const Cell& from = cells[static_cast<std::size_t>(agent)];
  const Cell& blocker = cells[static_cast<std::size_t>(by)];
  if (from == distances_[static_cast<std::size_t>(agent)].goal()) {
    return false;
  }
  char& own = is_taken_[static_cast<std::size_t>(grid_.indexOf(from))];
  char& in_the_way = is_taken_[static_cast<std::size_t>(grid_.indexOf(blocker))];
  own = 0;
  bool is_blocked = false;
  if (detour_cells_ < kLongestWayRound || partsSurroundings(blocker)) {
    const int without = pathLength(agent, from, kAnyLength);
    if (without != kNoPath) {
      in_the_way = 1;
      is_blocked = pathLength(agent, from, without + detour_cells_) == kNoPath;
      in_the_way = 0;
    }
  }
  own = 1;
  return is_blocked;
}

bool BlockingTest::isPassable(const Cell& cell) const {
  return grid_.isFree(cell) && is_taken_[static_cast<std::size_t>(grid_.indexOf(cell))] == 0;
}

// Whether two of the four sides of a cell are not connected by the eight cells round it.
bool BlockingTest::partsSurroundings(const Cell& cell) const {
  constexpr std::array<std::array<int, 2>, 8> kRing = {
      {{-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}}};
  std::array<bool, 8> is_passable{};
  for (std::size_t at = 0; at < kRing.size(); ++at) {
    is_passable[at] = isPassable({cell.row + kRing[at][0], cell.col + kRing[at][1]});
  }
  // Arcs of passable cells that touch a side; the sides are the even places of the ring.
  int arcs = 0;
  bool is_closed = true;
  for (std::size_t at = 0; at < kRing.size(); ++at) {
    is_closed = is_closed && is_passable[at];
    if (is_passable[at] && !is_passable[(at + 7) % 8]) {
      bool touches_side = false;
      for (std::size_t next = at; is_passable[next % 8]; ++next) {
        touches_side = touches_side || next % 2 == 0;
      }
      arcs += touches_side ? 1 : 0;
    }
  }
  return !is_closed && arcs > 1;
}

// Length of the shortest path among passable cells, or kNoPath if there is none as short as
// max_length. Best first by distance so far and distance to go on the empty map; the latter changes
// by one with each move, so that a deque keeps the order.
int BlockingTest::pathLength(AgentId agent, const Cell& from, int max_length) {
  struct Open {
    Cell cell;
    int length;
  };
  const sylph::DistanceField& to_go = distances_[static_cast<std::size_t>(agent)];
  ++search_;
  std::deque<Open> open = {{from, 0}};
  while (!open.empty()) {
    const Open current = open.front();
    open.pop_front();
    int& reached = reached_[static_cast<std::size_t>(grid_.indexOf(current.cell))];
    if (reached == search_) {
      continue;
    }
    reached = search_;
    const int here = to_go.at(current.cell);
    if (here == 0) {
      return current.length;
    }
    for (const sylph::Action action : sylph::kActions) {
      const Cell next = neighbor(current.cell, action);
      if (!isPassable(next) || current.length + 1 > max_length - to_go.at(next)) {
        continue;
      }
      if (to_go.at(next) < here) {
        open.push_front({next, current.length + 1});
      } else {
        open.push_back({next, current.length + 1});
      }
    }
  }
  return kNoPath;
}

}  // namespace sylph_training
