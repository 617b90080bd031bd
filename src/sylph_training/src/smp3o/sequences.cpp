#include "sylph_training/smp3o/sequences.hpp"

#include <algorithm>

namespace sylph_training {

std::vector<Sequence> cutIntoSequences(const std::vector<EpisodePiece>& pieces, int length) {
  std::vector<Sequence> sequences;
  for (const EpisodePiece& piece : pieces) {
    for (auto first = piece.first_rows.begin(); first != piece.first_rows.end();) {
      const auto left = std::distance(first, piece.first_rows.end());
      const auto end = first + std::min<std::ptrdiff_t>(left, length);
      sequences.push_back({piece.agents, {first, end}});
      first = end;
    }
  }
  return sequences;
}

SequenceLayout::SequenceLayout(std::vector<Sequence> sequences) {
  std::stable_sort(sequences.begin(), sequences.end(), [](const Sequence& a, const Sequence& b) {
    return a.first_rows.size() > b.first_rows.size();
  });
  const std::size_t steps = sequences.empty() ? 0 : sequences.front().first_rows.size();
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t rows_before = rows.size();
    for (const Sequence& sequence : sequences) {
      if (step >= sequence.first_rows.size()) {
        break;
      }
      const auto world_row = static_cast<std::int64_t>(rows.size());
      for (std::int64_t agent = 0; agent < sequence.agents; ++agent) {
        rows.push_back(sequence.first_rows[step] + agent);
        world_rows.push_back(world_row);
      }
    }
    step_counts.push_back(static_cast<std::int64_t>(rows.size() - rows_before));
  }
}

}  // namespace sylph_training
