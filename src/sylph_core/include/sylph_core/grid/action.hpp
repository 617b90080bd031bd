#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sylph_core/grid/cell.hpp"

namespace sylph {

/// What an agent does in one timestep. North is up on the map: towards row 0, +y in the map frame.
enum class Action : std::uint8_t { Stay = 0, North = 1, East = 2, South = 3, West = 4 };

/// Number of actions.
constexpr int kActionCount = 5;
constexpr std::array<Action, kActionCount> kActions = {Action::Stay, Action::North, Action::East,
                                                       Action::South, Action::West};

/// The cell that `action` leads to from `cell`, which may lie outside the grid.
constexpr Cell neighbor(const Cell& cell, Action action) {
  switch (action) {
    case Action::North:
      return {cell.row - 1, cell.col};
    case Action::East:
      return {cell.row, cell.col + 1};
    case Action::South:
      return {cell.row + 1, cell.col};
    case Action::West:
      return {cell.row, cell.col - 1};
    case Action::Stay:
      break;
  }
  return cell;
}

/// The action that leads from one cell to another, or none if they are neither equal nor adjacent.
constexpr std::optional<Action> actionBetween(const Cell& from, const Cell& to) {
  for (const Action action : kActions) {
    const Cell reached = neighbor(from, action);
    if (reached.row == to.row && reached.col == to.col) {
      return action;
    }
  }
  return std::nullopt;
}

}  // namespace sylph
