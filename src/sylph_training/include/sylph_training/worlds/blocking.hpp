#pragma once

#include <vector>

#include "sylph_core/grid/distance_field.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph_training {

/// Whom an agent on its goal is in the way of. He et al. 2024 (arXiv:2408.03063), "RL Reward
/// Structure"; the details are those of the authors' training code.
///
/// Agent i on its goal blocks agent j in its field of view if, with the other agents in that field
/// of view as obstacles, j's shortest path would be shorter by more than `detour_cells` without i,
/// or would exist only then. Instead of two searches for each pair, one asks first whether i's cell
/// parts its surroundings at all: where its free neighbours are connected among the eight cells
/// round it, the way round i is at most four cells longer.
class BlockingTest {
 public:
  /// @param grid, distances  per agent the distances to its goal; both must outlive this object
  /// @param detour_cells     >= 0
  /// @throws std::invalid_argument if detour_cells is negative
  BlockingTest(const sylph::Grid& grid, const std::vector<sylph::DistanceField>& distances,
               int detour_cells);

  /// Per agent on its goal the number of agents that it blocks, 0 for the others.
  /// @param cells  distinct free cells of the agents
  std::vector<int> count(const sylph::Configuration& cells);

 private:
  int countBlockedBy(sylph::AgentId agent, const sylph::Configuration& cells);
  bool isBlocked(sylph::AgentId agent, sylph::AgentId by, const sylph::Configuration& cells);
  bool partsSurroundings(const sylph::Cell& cell) const;
  int pathLength(sylph::AgentId agent, const sylph::Cell& from, int max_length);
  bool isPassable(const sylph::Cell& cell) const;

  const sylph::Grid& grid_;
  const std::vector<sylph::DistanceField>& distances_;
  int detour_cells_;
  std::vector<sylph::AgentId> occupant_;  // per cell, -1: nobody
  std::vector<char> is_taken_;            // per cell: an obstacle to the path that is searched
  std::vector<int> reached_;              // per cell: number of the search that reached it
  int search_ = 0;
};

}  // namespace sylph_training
