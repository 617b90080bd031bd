#include "sylph_core/grid/coarsen.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace sylph {
namespace {

/// Of a small cell: lengths that differ by less come from rounding.
constexpr double kRounding = 1e-6;

/// Numbers of obstacles in the rectangles between the upper left corner and each corner of a cell.
class ObstacleCounts {
 public:
  explicit ObstacleCounts(const Grid& grid) : cols_(grid.cols() + 1) {
    sums_.resize(static_cast<std::size_t>(grid.rows() + 1) * static_cast<std::size_t>(cols_));
    for (int row = 0; row < grid.rows(); ++row) {
      for (int col = 0; col < grid.cols(); ++col) {
        at(row + 1, col + 1) =
            at(row, col + 1) + at(row + 1, col) - at(row, col) + (grid.isFree({row, col}) ? 0 : 1);
      }
    }
  }

  /// Obstacles in rows and columns from the first up to, but without, the last.
  int between(int first_row, int last_row, int first_col, int last_col) {
    return at(last_row, last_col) - at(first_row, last_col) - at(last_row, first_col) +
           at(first_row, first_col);
  }

 private:
  int& at(int row, int col) {
    return sums_[static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) +
                 static_cast<std::size_t>(col)];
  }

  int cols_;
  std::vector<int> sums_;
};

/// Small cells that a stretch of one axis touches: from first up to, but without, last.
struct Touched {
  int first;
  int last;
};

Touched touchedBy(double low, double high) {
  return {static_cast<int>(std::floor(low + kRounding)),
          static_cast<int>(std::ceil(high - kRounding))};
}

void requireLengths(double small_m, double large_m, double margin_m) {
  // Comparisons are such that a NaN fails them.
  if (!(small_m > 0.0) || !(large_m >= small_m * (1.0 - kRounding)) || !std::isfinite(large_m)) {
    throw std::invalid_argument("cells of " + std::to_string(large_m) + " m from cells of " +
                                std::to_string(small_m) + " m: must be at least as large");
  }
  if (!(margin_m >= 0.0) || !std::isfinite(margin_m)) {
    throw std::invalid_argument("margin of " + std::to_string(margin_m) + " m: must be >= 0");
  }
}

}  // namespace

Grid coarsened(const Grid& grid, double small_m, double large_m, double margin_m) {
  requireLengths(small_m, large_m, margin_m);
  const double side = large_m / small_m;
  const double margin = margin_m / small_m;
  const int rows = static_cast<int>(grid.rows() / side + kRounding);
  const int cols = static_cast<int>(grid.cols() / side + kRounding);
  if (rows < 1 || cols < 1) {
    throw std::invalid_argument("a map of " + std::to_string(grid.rows() * small_m) + " x " +
                                std::to_string(grid.cols() * small_m) +
                                " m: smaller than one cell of " + std::to_string(large_m) + " m");
  }
  // Sums over rectangles: a map of a hall at 5 cm has millions of pixels, and each large cell asks
  // for its surroundings.
  ObstacleCounts obstacles(grid);
  Grid coarse(rows, cols);
  for (int row = 0; row < rows; ++row) {
    // Rows are counted from above; the lower left corner is what both maps share.
    const double bottom = grid.rows() - (rows - 1 - row) * side;
    const Touched r = touchedBy(bottom - side - margin, bottom + margin);
    for (int col = 0; col < cols; ++col) {
      const Touched c = touchedBy(col * side - margin, (col + 1) * side + margin);
      // What lies beyond the map is not known to be free.
      const bool is_inside =
          r.first >= 0 && r.last <= grid.rows() && c.first >= 0 && c.last <= grid.cols();
      coarse.setObstacle({row, col},
                         !is_inside || obstacles.between(r.first, r.last, c.first, c.last) > 0);
    }
  }
  return coarse;
}

}  // namespace sylph
