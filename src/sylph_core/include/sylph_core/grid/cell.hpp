#pragma once

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <ostream>
#include <string>
#include <tuple>

namespace sylph {

/// A square of the grid. Row 0 is the first line of the map file, which is the top; column 0 is
/// left.
struct Cell {
  int row = 0;  ///< 0: the first line of the map file, at the top
  int col = 0;  ///< 0: at the left
};

inline bool operator==(const Cell& a, const Cell& b) {
  return a.row == b.row && a.col == b.col;
}
inline bool operator!=(const Cell& a, const Cell& b) {
  return !(a == b);
}
inline bool operator<(const Cell& a, const Cell& b) {
  return std::tie(a.row, a.col) < std::tie(b.row, b.col);
}

/// "(row,col)", as in plan files and messages.
inline std::string toString(const Cell& cell) {
  return "(" + std::to_string(cell.row) + "," + std::to_string(cell.col) + ")";
}
inline std::ostream& operator<<(std::ostream& out, const Cell& cell) {
  return out << toString(cell);
}

/// Number of steps between two cells on a grid without obstacles.
inline int manhattanDistance(const Cell& a, const Cell& b) {
  return std::abs(a.row - b.row) + std::abs(a.col - b.col);
}

}  // namespace sylph

template <>
struct std::hash<sylph::Cell> {
  std::size_t operator()(const sylph::Cell& cell) const noexcept {
    return std::hash<long long>()((static_cast<long long>(cell.row) << 32) ^ cell.col);
  }
};
