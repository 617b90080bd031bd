#pragma once

#include <vector>

#include "sylph_core/grid/cell.hpp"
#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// Connected component of each cell.
struct Components {
  std::vector<int> label;                ///< per Grid::indexOf(), -1 on obstacles
  std::vector<std::vector<Cell>> cells;  ///< per component, row-major; largest component first
};

/// Of the free cells; cells are connected by their edges.
Components connectedComponents(const Grid& grid);

}  // namespace sylph
