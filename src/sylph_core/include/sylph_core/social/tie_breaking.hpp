#pragma once

#include <vector>

#include "sylph_core/grid/action.hpp"
#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Joint action without conflicts, and who is to blame for the change.
struct TieBreaking {
  std::vector<Action> actions;     ///< per agent; each is the agent's desired action or Stay
  std::vector<bool> is_penalized;  ///< per agent: gets the collision penalty instead of its reward
};

/// SVO-based tie-breaking. He et al. 2024 (arXiv:2408.03063), Alg. 3.
///
/// Agents are considered in descending order of SVO, equal ones by index: the most prosocial is
/// checked first and yields first. An invalid action (obstacle, boundary) or a restricted one
/// (another agent's target, or a swap) becomes Stay; whoever then heads for the cell of the agent
/// that stays is considered again. Of two agents in conflict the more prosocial is penalised, both
/// if their SVOs are equal. Where the algorithm as printed differs: its loop runs while the chain
/// is *not* empty, and agents are taken from its most prosocial end.
///
/// Terminates, since an action only ever changes to Stay and only agents that move are considered
/// again. Where `motion.rotations == false`, a rotation is a restricted action of the
/// member that is considered first, the most prosocial one.
///
/// @param cells    distinct free cells of the agents
/// @param desired  one action per agent
/// @param svo_deg  SVO of each agent [deg]
/// @throws std::invalid_argument if the sizes differ or two agents share a cell
TieBreaking breakTies(const Grid& grid, const MotionModel& motion, const Configuration& cells,
                      const std::vector<Action>& desired, const std::vector<float>& svo_deg);

}  // namespace sylph
