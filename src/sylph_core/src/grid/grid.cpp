#include "sylph_core/grid/grid.hpp"

#include <algorithm>
#include <stdexcept>

namespace sylph {

Grid::Grid(int rows, int cols) : rows_(rows), cols_(cols) {
  if (rows < 1 || rows > kMaxSide || cols < 1 || cols > kMaxSide) {
    throw std::invalid_argument("grid of " + std::to_string(rows) + " x " + std::to_string(cols) +
                                " cells: each side must be 1 ... " + std::to_string(kMaxSide));
  }
  obstacle_.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols), 0);
}

Grid Grid::fromText(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else if (c == '.' || c == '#') {
      lines.back().push_back(c);
    } else {
      throw std::invalid_argument(std::string("grid text: character '") + c +
                                  "' is neither '.' (free) nor '#' (obstacle)");
    }
  }
  if (lines.back().empty()) {
    lines.pop_back();
  }
  if (lines.empty()) {
    throw std::invalid_argument("grid text is empty");
  }
  Grid grid(static_cast<int>(lines.size()), static_cast<int>(lines.front().size()));
  for (int row = 0; row < grid.rows_; ++row) {
    const std::string& line = lines[static_cast<std::size_t>(row)];
    if (line.size() != lines.front().size()) {
      throw std::invalid_argument("grid text: line " + std::to_string(row + 1) + " has " +
                                  std::to_string(line.size()) + " characters, the first has " +
                                  std::to_string(lines.front().size()));
    }
    for (int col = 0; col < grid.cols_; ++col) {
      grid.setObstacle({row, col}, line[static_cast<std::size_t>(col)] == '#');
    }
  }
  return grid;
}

int Grid::freeCellCount() const {
  return static_cast<int>(std::count(obstacle_.begin(), obstacle_.end(), 0));
}

void Grid::setObstacle(const Cell& cell, bool obstacle) {
  if (!isInside(cell)) {
    throw std::out_of_range("cell " + toString(cell) + " lies outside a grid of " +
                            std::to_string(rows_) + " x " + std::to_string(cols_) + " cells");
  }
  obstacle_[static_cast<std::size_t>(indexOf(cell))] = obstacle ? 1 : 0;
}

std::vector<Cell> Grid::freeCells() const {
  std::vector<Cell> cells;
  for (int index = 0; index < size(); ++index) {
    if (obstacle_[static_cast<std::size_t>(index)] == 0) {
      cells.push_back(cellAt(index));
    }
  }
  return cells;
}

std::string Grid::toText() const {
  std::string text;
  text.reserve(static_cast<std::size_t>(size() + rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int col = 0; col < cols_; ++col) {
      text.push_back(isFree({row, col}) ? '.' : '#');
    }
    text.push_back('\n');
  }
  return text;
}

}  // namespace sylph
