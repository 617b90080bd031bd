#pragma once

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/grid/grid.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph::test {

inline int uniform(int low, int high, Rng& rng) {
  return low + static_cast<int>(drawIndex(rng, static_cast<std::size_t>(high - low + 1)));
}

template <typename Value>
const Value& pickOne(const std::vector<Value>& values, Rng& rng) {
  return values[static_cast<std::size_t>(uniform(0, static_cast<int>(values.size()) - 1, rng))];
}

/// Who cannot go where it heads, because of another's place, move or, if there is no such agent,
/// rotation.
inline std::vector<std::size_t> agentsInConflict(const Configuration& from, const Configuration& to,
                                                 bool rotations) {
  std::unordered_map<Cell, std::vector<std::size_t>> entrants;
  std::unordered_map<Cell, std::size_t> occupant;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    entrants[to[agent]].push_back(agent);
    occupant[from[agent]] = agent;
  }
  std::vector<std::size_t> result;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    const auto ahead = occupant.find(to[agent]);
    const bool is_swap = ahead != occupant.end() && to[ahead->second] == from[agent];
    if (to[agent] != from[agent] && (is_swap || entrants[to[agent]].size() > 1)) {
      result.push_back(agent);
    }
  }
  if (!rotations && result.empty()) {
    for (const auto& rotation : findRotations(from, to)) {
      result.insert(result.end(), rotation.begin(), rotation.end());
    }
  }
  return result;
}

/// Everybody walks at random; following is allowed, vertex and edge conflicts are not.
/// @param rotations  whether agents may rotate
inline Configuration randomStep(const Grid& grid, const Configuration& from, bool rotations,
                                Rng& rng) {
  Configuration to = from;
  for (Cell& cell : to) {
    const Cell target = neighbor(cell, kActions[static_cast<std::size_t>(uniform(0, 4, rng))]);
    cell = grid.isFree(target) ? target : cell;
  }
  // Whoever is in conflict stays. That makes new conflicts with those behind, until nobody moves at
  // worst.
  for (auto in_conflict = agentsInConflict(from, to, rotations); !in_conflict.empty();
       in_conflict = agentsInConflict(from, to, rotations)) {
    for (const std::size_t agent : in_conflict) {
      to[agent] = from[agent];
    }
  }
  return to;
}

inline Plan randomWalk(const Grid& grid, const Configuration& start, int steps, bool rotations,
                       Rng& rng) {
  Plan plan = {start};
  for (int step = 0; step < steps; ++step) {
    plan.push_back(randomStep(grid, plan.back(), rotations, rng));
  }
  return plan;
}

/// A crowded little world and a random walk in it.
inline Plan randomPlan(Rng& rng, bool rotations = false) {
  const Grid grid(uniform(2, 5, rng), uniform(2, 5, rng));
  Configuration cells = grid.freeCells();
  shuffle(cells, rng);
  cells.resize(static_cast<std::size_t>(uniform(1, std::max(1, grid.size() - 1), rng)));
  return randomWalk(grid, cells, uniform(0, 20, rng), rotations, rng);
}

}  // namespace sylph::test
