#include "sylph_training/worlds/collisions.hpp"

#include <stdexcept>
#include <string>

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::Cell;

/// The joint action as it stands, seen from the cells of the map.
class Traffic {
 public:
  Traffic(const sylph::Grid& grid, const sylph::Configuration& cells,
          const std::vector<Action>& actions)
      : grid_(grid),
        cells_(cells),
        actions_(actions),
        occupant_(static_cast<std::size_t>(grid.size()), -1),
        heading_for_(occupant_.size(), 0) {
    for (std::size_t agent = 0; agent < cells.size(); ++agent) {
      occupant_[indexOf(cells[agent])] = static_cast<sylph::AgentId>(agent);
      if (grid.isFree(target(agent))) {
        ++heading_for_[indexOf(target(agent))];
      }
    }
  }

  bool isImpossible(std::size_t agent, bool rotations) const {
    if (actions_[agent] == Action::Stay) {
      return false;
    }
    return !grid_.isFree(target(agent)) || heading_for_[indexOf(target(agent))] > 1 ||
           isInRotation(agent, rotations);
  }

 private:
  Cell target(std::size_t agent) const { return neighbor(cells_[agent], actions_[agent]); }
  std::size_t indexOf(const Cell& cell) const {
    return static_cast<std::size_t>(grid_.indexOf(cell));
  }

  // A swap is a rotation of two, which no agents can make.
  bool isInRotation(std::size_t agent, bool rotations) const {
    std::size_t ahead = agent;
    for (std::size_t length = 1; length <= cells_.size(); ++length) {
      const Cell next = target(ahead);
      const int occupant = grid_.isFree(next) ? occupant_[indexOf(next)] : -1;
      if (occupant < 0 || static_cast<std::size_t>(occupant) == ahead) {
        return false;
      }
      ahead = static_cast<std::size_t>(occupant);
      if (ahead == agent) {
        return length == 2 || !rotations;
      }
    }
    return false;
  }

  const sylph::Grid& grid_;
  const sylph::Configuration& cells_;
  const std::vector<Action>& actions_;
  std::vector<sylph::AgentId> occupant_;
  std::vector<int> heading_for_;
};

}  // namespace

sylph::TieBreaking haltCollisions(const sylph::Grid& grid, const sylph::MotionModel& motion,
                                  const sylph::Configuration& cells,
                                  const std::vector<Action>& desired) {
  if (desired.size() != cells.size()) {
    throw std::invalid_argument(std::to_string(cells.size()) + " cells and " +
                                std::to_string(desired.size()) + " actions: must be one per agent");
  }
  sylph::TieBreaking result{desired, std::vector<bool>(cells.size(), false)};
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    const std::vector<Action> actions = result.actions;
    const Traffic traffic(grid, cells, actions);
    for (std::size_t agent = 0; agent < cells.size(); ++agent) {
      if (traffic.isImpossible(agent, motion.rotations)) {
        result.actions[agent] = Action::Stay;
        result.is_penalized[agent] = true;
        has_changed = true;
      }
    }
  }
  return result;
}

}  // namespace sylph_training
