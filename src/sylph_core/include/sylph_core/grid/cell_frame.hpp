#pragma once

#include "sylph_core/geometry/vector2.hpp"
#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// The one conversion between cells and metres of the suite. Points are in the `map` frame: x
/// right, y up, origin at the lower left corner of the map.
///
/// x = (col + 0.5) * cell_size_m, y = (rows - row - 0.5) * cell_size_m
class CellFrame {
 public:
  /// @throws std::invalid_argument unless rows > 0 and cell_size_m is finite and > 0
  CellFrame(int rows, double cell_size_m);
  CellFrame(const Grid& grid, double cell_size_m) : CellFrame(grid.rows(), cell_size_m) {}

  /// Centre of a cell [m].
  Point toPoint(const Cell& cell) const;
  /// The cell that contains a point [m]; it may lie outside the grid.
  Cell toCell(const Point& point) const;

  /// Side of a cell [m].
  double cellSize() const { return cell_size_m_; }

 private:
  int rows_;
  double cell_size_m_;
};

}  // namespace sylph
