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
  for (bool is_settled = false; !is_settled;) {
    is_settled = true;
    const auto stay = [&](std::size_t agent) {
      is_settled = is_settled && to[agent] == from[agent];
      to[agent] = from[agent];
    };
    std::unordered_map<Cell, std::vector<std::size_t>> entrants;
    std::unordered_map<Cell, std::size_t> occupant;
    for (std::size_t agent = 0; agent < from.size(); ++agent) {
      entrants[to[agent]].push_back(agent);
      occupant[from[agent]] = agent;
    }
    for (const auto& [cell, agents] : entrants) {
      if (agents.size() > 1) {
        std::for_each(agents.begin(), agents.end(), stay);
      }
    }
    for (std::size_t agent = 0; agent < from.size(); ++agent) {
      const auto ahead = occupant.find(to[agent]);
      if (ahead != occupant.end() && ahead->second != agent && to[ahead->second] == from[agent]) {
        stay(ahead->second);
        stay(agent);
      }
    }
    if (!rotations && is_settled) {
      for (const auto& rotation : findRotations(from, to)) {
        for (const AgentId agent : rotation) {
          stay(static_cast<std::size_t>(agent));
        }
      }
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
