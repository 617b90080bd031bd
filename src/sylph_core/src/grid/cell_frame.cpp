#include "sylph_core/grid/cell_frame.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace sylph {

CellFrame::CellFrame(int rows, double cell_size_m, const Point& corner)
    : rows_(rows), cell_size_m_(cell_size_m), corner_(corner) {
  if (rows <= 0) {
    throw std::invalid_argument("cell frame of " + std::to_string(rows) + " rows: must be > 0");
  }
  if (!std::isfinite(cell_size_m) || cell_size_m <= 0.0) {
    throw std::invalid_argument("cell size " + std::to_string(cell_size_m) + " m: must be > 0");
  }
  if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) {
    throw std::invalid_argument("corner of the map: must be finite");
  }
}

Point CellFrame::toPoint(const Cell& cell) const {
  // Row 0 is the first line of the map file, which is the top; y counts from the bottom.
  return {corner_.x + (cell.col + 0.5) * cell_size_m_,
          corner_.y + (rows_ - cell.row - 0.5) * cell_size_m_};
}

Cell CellFrame::toCell(const Point& point) const {
  return {rows_ - 1 - static_cast<int>(std::floor((point.y - corner_.y) / cell_size_m_)),
          static_cast<int>(std::floor((point.x - corner_.x) / cell_size_m_))};
}

std::vector<Cell> CellFrame::cellsUnder(const Point& center, const Vector2& half_box) const {
  const Cell top_left = toCell(center + Vector2{-half_box.x, half_box.y});
  const Cell bottom_right = toCell(center + Vector2{half_box.x, -half_box.y});
  std::vector<Cell> cells;
  for (int row = top_left.row; row <= bottom_right.row; ++row) {
    for (int col = top_left.col; col <= bottom_right.col; ++col) {
      cells.push_back({row, col});
    }
  }
  return cells;
}

}  // namespace sylph
