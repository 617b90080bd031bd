#include "sylph_core/grid/components.hpp"

#include <algorithm>

#include "sylph_core/grid/action.hpp"

namespace sylph {
namespace {

std::vector<Cell> floodFill(const Grid& grid, const Cell& seed, std::vector<int>& label, int mark) {
  std::vector<Cell> cells = {seed};
  label[static_cast<std::size_t>(grid.indexOf(seed))] = mark;
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const Cell cell = cells[next];
    for (const Action action : kActions) {
      const Cell reached = neighbor(cell, action);
      if (grid.isFree(reached) && label[static_cast<std::size_t>(grid.indexOf(reached))] < 0) {
        label[static_cast<std::size_t>(grid.indexOf(reached))] = mark;
        cells.push_back(reached);
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace

Components connectedComponents(const Grid& grid) {
  Components components;
  components.label.assign(static_cast<std::size_t>(grid.size()), -1);
  for (const Cell& cell : grid.freeCells()) {
    if (components.label[static_cast<std::size_t>(grid.indexOf(cell))] < 0) {
      components.cells.push_back(
          floodFill(grid, cell, components.label, static_cast<int>(components.cells.size())));
    }
  }
  // The largest first, which is where starts and goals are drawn.
  std::stable_sort(components.cells.begin(), components.cells.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (std::size_t index = 0; index < components.cells.size(); ++index) {
    for (const Cell& cell : components.cells[index]) {
      components.label[static_cast<std::size_t>(grid.indexOf(cell))] = static_cast<int>(index);
    }
  }
  return components;
}

}  // namespace sylph
