#pragma once

#include <array>

#include "sylph_core/grid/action.hpp"
#include "sylph_training/imitation/scene_store.hpp"

namespace sylph_training {

/// One of the eight symmetries of the square: maybe mirrored, east and west changing places, then
/// turned clockwise by quarters. The world looks as likely after it as before, so that each sample
/// stands for eight.
class Symmetry {
 public:
  static constexpr int kCount = 8;

  /// @param index  0 (nothing changes) ... kCount - 1
  explicit Symmetry(int index);

  sylph::Action apply(sylph::Action action) const {
    return actions_[static_cast<std::size_t>(action)];
  }
  PackedView apply(const PackedView& view) const;
  /// Only the direction to the goal changes.
  std::array<float, sylph::kVectorSize> apply(
      const std::array<float, sylph::kVectorSize>& vector) const;

  /// The symmetry that undoes this one.
  Symmetry inverse() const;
  int index() const { return index_; }

 private:
  int index_;
  std::array<sylph::Action, sylph::kActionCount> actions_{};
  std::array<int, sylph::kViewCells> cells_{};      // per cell, where it goes
  std::array<std::uint32_t, 16> direction_bits_{};  // four channels, North first
};

}  // namespace sylph_training
