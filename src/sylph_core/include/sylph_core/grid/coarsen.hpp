#pragma once

#include "sylph_core/grid/grid.hpp"

namespace sylph {

/// A map of small cells as one of larger cells with the same lower left corner. A cell is free if
/// its whole square, grown by the margin on each side, lies on free cells of the small ones. What
/// is left of the map at its upper and right edge, being less than a cell, is dropped.
///
/// @param small_m   side of a small cell [m], > 0
/// @param large_m   side of a large one [m], at least small_m; no whole multiple is needed
/// @param margin_m  how far a robot that stands in a cell reaches beyond its edges [m], >= 0
/// @throws std::invalid_argument if a length is out of bounds or the map is smaller than one cell
Grid coarsened(const Grid& grid, double small_m, double large_m, double margin_m);

}  // namespace sylph
