#pragma once

#include <vector>

#include "sylph_core/geometry/vector2.hpp"
#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// The one conversion between cells and metres of the suite. Points are in the `map` frame: x
/// right, y up; its origin is the lower left corner of the map, unless the map says where that
/// corner lies in it.
///
/// x = corner.x + (col + 0.5) * cell_size_m, y = corner.y + (rows - row - 0.5) * cell_size_m
class CellFrame {
 public:
  /// @param corner  the lower left corner of the map [m]
  /// @throws std::invalid_argument unless rows > 0, cell_size_m is finite and > 0 and the corner is
  /// finite
  CellFrame(int rows, double cell_size_m, const Point& corner = {});
  CellFrame(const Grid& grid, double cell_size_m, const Point& corner = {})
      : CellFrame(grid.rows(), cell_size_m, corner) {}

  /// Centre of a cell [m].
  Point toPoint(const Cell& cell) const;
  /// The cell that contains a point [m]; it may lie outside the grid.
  Cell toCell(const Point& point) const;

  /// The cells, row by row, that a box touches; they may lie outside the grid.
  /// @param half_box  half its sides along x and y [m], >= 0
  std::vector<Cell> cellsUnder(const Point& center, const Vector2& half_box) const;

  /// Side of a cell [m].
  double cellSize() const { return cell_size_m_; }

 private:
  int rows_;
  double cell_size_m_;
  Point corner_;
};

}  // namespace sylph
