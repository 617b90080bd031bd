#include "sylph_training/imitation/symmetry.hpp"

#include <stdexcept>
#include <string>

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::Channel;

constexpr int kQuarters = 4;
// The groups of four channels that stand for directions.
constexpr std::array<Channel, 5> kDirections = {Channel::NearerNorth, Channel::DesiredNorth,
                                                Channel::CameNorth, Channel::SwapNorth,
                                                Channel::ClearNorth};

Action mirrored(Action action) {
  switch (action) {
    case Action::East:
      return Action::West;
    case Action::West:
      return Action::East;
    default:
      return action;
  }
}

Action turned(Action action) {
  return action == Action::Stay ? action
                                : static_cast<Action>(static_cast<int>(action) % kQuarters + 1);
}

}  // namespace

Symmetry::Symmetry(int index) : index_(index) {
  if (index < 0 || index >= kCount) {
    throw std::invalid_argument("symmetry " + std::to_string(index) + ": must be 0 ... 7");
  }
  const bool is_mirrored = index >= kQuarters;
  const int turns = index % kQuarters;
  for (const Action action : sylph::kActions) {
    Action& image = actions_[static_cast<std::size_t>(action)];
    image = is_mirrored ? mirrored(action) : action;
    for (int turn = 0; turn < turns; ++turn) {
      image = turned(image);
    }
  }
  constexpr int kLast = sylph::kFieldOfView - 1;
  for (int cell = 0; cell < sylph::kViewCells; ++cell) {
    int row = cell / sylph::kFieldOfView;
    int col = cell % sylph::kFieldOfView;
    col = is_mirrored ? kLast - col : col;
    for (int turn = 0; turn < turns; ++turn) {
      const int old_row = row;
      row = col;
      col = kLast - old_row;
    }
    cells_[static_cast<std::size_t>(cell)] = row * sylph::kFieldOfView + col;
  }
  for (std::uint32_t bits = 0; bits < direction_bits_.size(); ++bits) {
    for (std::uint32_t direction = 0; direction < kQuarters; ++direction) {
      const Action image = apply(static_cast<Action>(direction + 1));
      direction_bits_[bits] |= ((bits >> direction) & 1U)
                               << (static_cast<std::uint32_t>(image) - 1);
    }
  }
}

PackedView Symmetry::apply(const PackedView& view) const {
  PackedView image;
  for (std::size_t cell = 0; cell < view.size(); ++cell) {
    std::uint64_t word = view[cell];
    for (const Channel first : kDirections) {
      const auto shift = static_cast<std::uint32_t>(first);
      const std::uint64_t bits = (word >> shift) & 0xFU;
      word = (word & ~(std::uint64_t{0xF} << shift)) |
             static_cast<std::uint64_t>(direction_bits_[bits]) << shift;
    }
    image[static_cast<std::size_t>(cells_[cell])] = word;
  }
  return image;
}

std::array<float, sylph::kVectorSize> Symmetry::apply(
    const std::array<float, sylph::kVectorSize>& vector) const {
  auto image = vector;
  if (index_ >= kQuarters) {
    image[0] = -image[0];
  }
  for (int turn = 0; turn < index_ % kQuarters; ++turn) {
    const float right = image[0];
    image[0] = image[1];
    image[1] = -right;
  }
  return image;
}

Symmetry Symmetry::inverse() const {
  // A mirror image turned is its own inverse; else the turns have to add up to four.
  return Symmetry(index_ >= kQuarters ? index_ : (kQuarters - index_) % kQuarters);
}

}  // namespace sylph_training
