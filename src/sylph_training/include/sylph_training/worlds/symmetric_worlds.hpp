#pragma once

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/mapf/instance.hpp"

namespace sylph_training {

/// The symmetric case study: two agents at the ends of a corridor as wide as one of them, each with
/// the other's start as its goal. He et al. 2024 (arXiv:2408.03063), "Symmetric Pathfinding Case
/// Study".
struct SymmetricWorldSpec {
  double recess_share = 0.8;  ///< of corridors with two recesses, the others are I-shaped; 0 ... 1
  int min_length = 5;         ///< of the corridor [cells], >= 5
  int max_length = 11;        ///< >= min_length

  /// @throws std::invalid_argument naming the member and what is allowed
  void requireValid() const;
};

/// A corridor with two recesses of one cell each, opposite in place (the same distance from either
/// end) and in side: the world turned by half is the same world.
/// @param length       of the corridor [cells], >= 5
/// @param recess_cell  of the first recess, from the corridor's end, 1 ... (length - 1) / 2
/// @throws std::invalid_argument if either is out of its range
sylph::Instance recessWorld(int length, int recess_cell);

/// A corridor that ends in the middle of a crossbar of three cells at either end, where the agents
/// start. There one of them has to leave its goal for the other one.
/// @param length  of the corridor with its ends [cells], >= 3
/// @throws std::invalid_argument if it is shorter
sylph::Instance iShapedWorld(int length);

/// One of the two, of random length and with recesses in a random place.
/// @throws std::invalid_argument if the specification is not valid
sylph::Instance symmetricWorld(const SymmetricWorldSpec& spec, sylph::Rng& rng);

}  // namespace sylph_training
