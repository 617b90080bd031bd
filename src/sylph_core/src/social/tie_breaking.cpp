#include "sylph_core/social/tie_breaking.hpp"

#include <algorithm>
#include <deque>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

namespace sylph {
namespace {

/// Who is where and who heads where, kept up to date while actions change to Stay.
class JointAction {
 public:
  JointAction(const Configuration& cells, std::vector<Action> desired)
      : cells_(cells), actions_(std::move(desired)) {
    for (std::size_t agent = 0; agent < cells.size(); ++agent) {
      const auto id = static_cast<AgentId>(agent);
      if (!occupant_.emplace(cells[agent], id).second) {
        throw std::invalid_argument("two agents share cell " + toString(cells[agent]));
      }
      heading_for_[target(id)].push_back(id);
    }
  }

  Cell target(AgentId agent) const {
    const auto index = static_cast<std::size_t>(agent);
    return neighbor(cells_[index], actions_[index]);
  }

  void stay(AgentId agent) {
    std::vector<AgentId>& group = heading_for_[target(agent)];
    group.erase(std::find(group.begin(), group.end(), agent));
    actions_[static_cast<std::size_t>(agent)] = Action::Stay;
    heading_for_[target(agent)].push_back(agent);
  }

  /// The agents that make an agent's action a restricted one: heading for its target, or swapping
  /// with it.
  std::vector<AgentId> rivals(AgentId agent) const {
    std::vector<AgentId> found;
    for (const AgentId other : heading_for_.at(target(agent))) {
      if (other != agent) {
        found.push_back(other);
      }
    }
    const auto other = occupant_.find(target(agent));
    if (other != occupant_.end() && other->second != agent &&
        target(other->second) == cells_[static_cast<std::size_t>(agent)]) {
      found.push_back(other->second);
    }
    return found;
  }

  /// Whether the agent is one of a rotation, in which each enters the cell that the next one
  /// leaves.
  bool isInRotation(AgentId agent) const {
    AgentId ahead = agent;
    for (std::size_t hops = 0; hops < cells_.size(); ++hops) {
      const auto next = occupant_.find(target(ahead));
      if (next == occupant_.end() || next->second == ahead) {
        return false;
      }
      ahead = next->second;
      if (ahead == agent) {
        return true;
      }
    }
    return false;
  }

  const std::vector<Action>& actions() const { return actions_; }

 private:
  const Configuration& cells_;
  std::vector<Action> actions_;
  std::unordered_map<Cell, AgentId> occupant_;
  std::unordered_map<Cell, std::vector<AgentId>> heading_for_;
};

/// The agents still to be considered, each at most once.
class ConsiderationChain {
 public:
  explicit ConsiderationChain(const std::vector<float>& svo_deg)
      : chain_(svo_deg.size()), is_in_(svo_deg.size(), true) {
    std::iota(chain_.begin(), chain_.end(), 0);
    // Alg. 3: the most prosocial gives way first; equals by index.
    std::stable_sort(chain_.begin(), chain_.end(), [&](AgentId a, AgentId b) {
      return svo_deg[static_cast<std::size_t>(a)] > svo_deg[static_cast<std::size_t>(b)];
    });
  }
  bool isEmpty() const { return chain_.empty(); }
  AgentId take() {
    const AgentId agent = chain_.front();
    chain_.pop_front();
    is_in_[static_cast<std::size_t>(agent)] = false;
    return agent;
  }
  void append(const std::vector<AgentId>& agents) {
    for (const AgentId agent : agents) {
      if (!is_in_[static_cast<std::size_t>(agent)]) {
        is_in_[static_cast<std::size_t>(agent)] = true;
        chain_.push_back(agent);
      }
    }
  }

 private:
  std::deque<AgentId> chain_;
  std::vector<bool> is_in_;
};

}  // namespace

TieBreaking breakTies(const Grid& grid, const MotionModel& motion, const Configuration& cells,
                      const std::vector<Action>& desired, const std::vector<float>& svo_deg) {
  if (desired.size() != cells.size() || svo_deg.size() != cells.size()) {
    throw std::invalid_argument(std::to_string(cells.size()) + " cells, " +
                                std::to_string(desired.size()) + " actions and " +
                                std::to_string(svo_deg.size()) + " SVOs: must be one per agent");
  }
  JointAction joint(cells, desired);
  ConsiderationChain chain(svo_deg);
  std::vector<bool> is_penalized(cells.size(), false);
  const auto penalize = [&](AgentId agent, AgentId rival) {
    const float own = svo_deg[static_cast<std::size_t>(agent)];
    const float others = svo_deg[static_cast<std::size_t>(rival)];
    if (own >= others) {
      is_penalized[static_cast<std::size_t>(agent)] = true;
    }
    if (others >= own) {
      is_penalized[static_cast<std::size_t>(rival)] = true;
    }
  };
  while (!chain.isEmpty()) {
    const AgentId agent = chain.take();
    const std::vector<AgentId> rivals = joint.rivals(agent);
    const bool is_blocked = !grid.isFree(joint.target(agent)) ||
                            (rivals.empty() && !motion.rotations && joint.isInRotation(agent));
    if (is_blocked) {
      is_penalized[static_cast<std::size_t>(agent)] = true;
    } else if (!rivals.empty()) {
      for (const AgentId rival : rivals) {
        penalize(agent, rival);
      }
    } else {
      continue;
    }
    joint.stay(agent);
    chain.append(joint.rivals(agent));
  }
  return {joint.actions(), std::move(is_penalized)};
}

}  // namespace sylph
