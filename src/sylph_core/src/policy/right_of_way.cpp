#include "sylph_core/policy/right_of_way.hpp"

#include <algorithm>
#include <numeric>

#include "sylph_core/policy/swap_rule.hpp"

namespace sylph {
namespace {

constexpr std::size_t kDirections = 4;
constexpr std::size_t kNoDirection = kDirections;
constexpr AgentId kNoAgent = -1;

}  // namespace

/// An agent that has to leave its cell.
struct RightOfWay::Push {
  AgentId agent;
  std::size_t back;  ///< direction of who pushes it, kNoDirection if it goes of its own accord
};

RightOfWay::RightOfWay(const OccupancyMap& map, const std::vector<DistanceField>& distances)
    : map_(&map), distances_(&distances) {}

void RightOfWay::setStates(const Configuration& cells, const std::vector<float>& svo_deg) {
  at_.clear();
  desired_.assign(cells.size(), {});
  swaps_.assign(cells.size(), {});
  clears_.assign(cells.size(), {});
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    at_.push_back(map_->indexOf(cells[agent]));
    const int to_go = toGo(static_cast<AgentId>(agent), at_.back());
    for (std::size_t way = 0; way < kDirections; ++way) {
      desired_[agent][way] =
          toGo(static_cast<AgentId>(agent), at_.back() + map_->steps()[way]) < to_go;
    }
  }
  for (std::size_t agent = 0; agent < cells.size(); ++agent) {
    findSwaps(static_cast<AgentId>(agent));
  }
  inherit(svo_deg);
}

// As Pibt does before an agent chooses, for each of its desired moves.
void RightOfWay::findSwaps(AgentId agent) {
  const int at = at_[index(agent)];
  for (std::size_t desired = 0; desired < kDirections; ++desired) {
    if (!desired_[index(agent)][desired]) {
      continue;
    }
    const int to = at + map_->steps()[desired];
    const AgentId ahead = map_->occupant(to);
    if (ahead >= 0 && haveToSwap(agent, ahead, at, to)) {
      swaps_[index(agent)][desired] = true;
    }
    for (std::size_t side = 0; side < kDirections; ++side) {
      const AgentId beside = map_->occupant(at + map_->steps()[side]);
      if (side != desired && beside >= 0 && haveToSwap(beside, agent, at, to)) {
        clears_[index(agent)][side] = true;
      }
    }
  }
}

bool RightOfWay::haveToSwap(AgentId pusher, AgentId puller, int from, int to) const {
  const auto distance = [this](AgentId agent, int at) { return toGo(agent, at); };
  const auto ways = [this](int at, int back, int& onward) { return waysOn(at, back, onward); };
  return mustSwap(distance, ways, pusher, puller, from, to) && canSwap(ways, to, from);
}

int RightOfWay::waysOn(int at, int back, int& onward) const {
  const auto isDeadEnd = [this](int place) {
    return std::count_if(map_->steps().begin(), map_->steps().end(),
                         [&](int step) { return !map_->isObstacle(place + step); }) == 1;
  };
  int ways = 0;
  for (const int step : map_->steps()) {
    const int to = at + step;
    if (to == back || map_->isObstacle(to)) {
      continue;
    }
    const AgentId occupant = map_->occupant(to);
    const bool is_closed = occupant >= 0 && toGo(occupant, to) == 0 && isDeadEnd(to);
    if (!is_closed) {
      ++ways;
      onward = to;
    }
  }
  return ways;
}

// Pushes spread from the lowest SVO upwards, so that whoever is reached has its least one. An agent
// passes pushes from several sides on, whichever comes first, so that turned maps give the same.
void RightOfWay::inherit(const std::vector<float>& svo_deg) {
  inherited_deg_ = svo_deg;
  std::vector<AgentId> order(svo_deg.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](AgentId left, AgentId right) {
    return svo_deg[index(left)] < svo_deg[index(right)];
  });
  std::vector<AgentId> pushed_by(svo_deg.size(), kNoAgent);  // the first of the chain
  std::vector<std::array<bool, kDirections>> is_passed_on(svo_deg.size());
  std::vector<Push> open;
  for (const AgentId first : order) {
    if (pushed_by[index(first)] != kNoAgent) {
      continue;
    }
    pushed_by[index(first)] = first;
    open.push_back({first, kNoDirection});
    while (!open.empty()) {
      const Push push = open.back();
      open.pop_back();
      const Directions onward = onwardOf(push);
      for (std::size_t way = 0; way < kDirections; ++way) {
        if (!onward[way]) {
          continue;
        }
        const AgentId pushed = map_->occupant(at_[index(push.agent)] + map_->steps()[way]);
        const std::size_t back = (way + kDirections / 2) % kDirections;
        if (pushed_by[index(pushed)] == kNoAgent) {
          pushed_by[index(pushed)] = first;
          inherited_deg_[index(pushed)] = svo_deg[index(first)];
        }
        if (pushed_by[index(pushed)] == first && !is_passed_on[index(pushed)][back]) {
          is_passed_on[index(pushed)][back] = true;
          open.push_back({pushed, back});
        }
      }
    }
  }
}

RightOfWay::Directions RightOfWay::onwardOf(const Push& push) const {
  const int at = at_[index(push.agent)];
  const auto isTaken = [&](std::size_t way) {
    return map_->occupant(at + map_->steps()[way]) >= 0;
  };
  Directions taken_moves{};
  Directions around{};
  bool is_anything_desired = false;
  bool is_anything_free = false;
  for (std::size_t way = 0; way < kDirections; ++way) {
    if (way == push.back || map_->isObstacle(at + map_->steps()[way])) {
      continue;
    }
    if (desired_[index(push.agent)][way]) {
      is_anything_desired = true;
      taken_moves[way] = isTaken(way);
    }
    around[way] = isTaken(way);
    is_anything_free = is_anything_free || !around[way];
  }
  if (push.back == kNoDirection || is_anything_desired) {
    return taken_moves;
  }
  return is_anything_free ? Directions{} : around;
}

}  // namespace sylph
