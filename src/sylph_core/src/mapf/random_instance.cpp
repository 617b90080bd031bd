#include "sylph_core/mapf/random_instance.hpp"

#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

#include "sylph_core/grid/components.hpp"

namespace sylph {

Configuration drawCells(const Grid& grid, int count, Rng& rng) {
  Configuration cells = grid.freeCells();
  if (count < 0 || count > static_cast<int>(cells.size())) {
    throw std::invalid_argument(std::to_string(count) + " agents on a map of " +
                                std::to_string(cells.size()) + " free cells");
  }
  shuffle(cells, rng);
  cells.resize(static_cast<std::size_t>(count));
  return cells;
}

Configuration drawReachableCells(const Grid& grid, const Configuration& from, Rng& rng) {
  Components components = connectedComponents(grid);
  for (std::vector<Cell>& cells : components.cells) {
    shuffle(cells, rng);
  }
  std::unordered_set<Cell> seen;
  Configuration drawn;
  for (const Cell& cell : from) {
    if (!grid.isFree(cell) || !seen.insert(cell).second) {
      throw std::invalid_argument("cell " + toString(cell) +
                                  " is not free or is given to two agents");
    }
    const int label = components.label[static_cast<std::size_t>(grid.indexOf(cell))];
    std::vector<Cell>& cells = components.cells[static_cast<std::size_t>(label)];
    drawn.push_back(cells.back());
    cells.pop_back();
  }
  return drawn;
}

Instance randomInstance(const Grid& grid, int agents, const MotionModel& motion, Rng& rng) {
  if (agents < 1) {
    throw std::invalid_argument(std::to_string(agents) + " agents: must be 1 or more");
  }
  Instance instance{grid, drawCells(grid, agents, rng), {}, motion};
  instance.goals = drawReachableCells(grid, instance.starts, rng);
  return instance;
}

}  // namespace sylph
