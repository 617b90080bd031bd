#pragma once

#include <cstdint>
#include <vector>

#include "sylph_training/smp3o/rollout.hpp"

namespace sylph_training {

/// Consecutive steps of one world's agents through which gradients go back.
struct Sequence {
  std::int64_t agents = 0;               ///< of the world
  std::vector<std::int64_t> first_rows;  ///< as in EpisodePiece

  /// Agent steps.
  std::int64_t rowCount() const { return agents * static_cast<std::int64_t>(first_rows.size()); }
};

/// Cuts pieces into sequences of `length` steps; the last of each piece may be shorter.
std::vector<Sequence> cutIntoSequences(const std::vector<EpisodePiece>& pieces, int length);

/// Sequences side by side: all their first steps, then all their second steps, and so on. The
/// longest come first, so that the agents of a step are the first ones of the step before.
struct SequenceLayout {
  std::vector<std::int64_t> rows;         ///< of the rollout
  std::vector<std::int64_t> world_rows;   ///< per row: where its world's first agent lies here
  std::vector<std::int64_t> step_counts;  ///< rows of each step, not increasing

  explicit SequenceLayout(std::vector<Sequence> sequences);
};

}  // namespace sylph_training
