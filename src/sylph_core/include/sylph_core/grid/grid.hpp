#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sylph_core/grid/cell.hpp"

namespace sylph {

/// A rectangular 4-connected map of free cells and obstacles.
class Grid {
 public:
  Grid() = default;

  /// A grid without obstacles.
  /// @throws std::invalid_argument if rows or cols is not in 1 ... kMaxSide
  Grid(int rows, int cols);

  /// A grid from text, '.' free and '#' obstacle, one row a line: "..#\n...\n".
  /// @throws std::invalid_argument on other characters, unequal line lengths or an empty text
  static Grid fromText(const std::string& text);

  /// Cells from top to bottom.
  int rows() const { return rows_; }
  /// Cells from left to right.
  int cols() const { return cols_; }
  /// rows * cols
  int size() const { return rows_ * cols_; }
  /// Cells without an obstacle; counts each time.
  int freeCellCount() const;

  /// Free or not.
  bool isInside(const Cell& cell) const {
    return cell.row >= 0 && cell.row < rows_ && cell.col >= 0 && cell.col < cols_;
  }
  /// Inside and not an obstacle.
  bool isFree(const Cell& cell) const {
    return isInside(cell) && obstacle_[static_cast<std::size_t>(indexOf(cell))] == 0;
  }
  /// @throws std::out_of_range if the cell lies outside
  void setObstacle(const Cell& cell, bool obstacle = true);

  /// Row-major index of a cell inside, 0 ... size() - 1.
  int indexOf(const Cell& cell) const { return cell.row * cols_ + cell.col; }
  /// The cell of such an index.
  Cell cellAt(int index) const { return {index / cols_, index % cols_}; }

  /// Free cells in row-major order.
  std::vector<Cell> freeCells() const;

  /// The text that fromText() reads.
  std::string toText() const;

  friend bool operator==(const Grid& a, const Grid& b) {
    return a.rows_ == b.rows_ && a.cols_ == b.cols_ && a.obstacle_ == b.obstacle_;
  }
  friend bool operator!=(const Grid& a, const Grid& b) { return !(a == b); }

  /// Rows and columns, at most: what a MovingAI map needs, and memory has room for.
  static constexpr int kMaxSide = 8192;

 private:
  int rows_ = 0;
  int cols_ = 0;
  std::vector<std::uint8_t> obstacle_;  // row-major, 1 = obstacle
};

}  // namespace sylph
