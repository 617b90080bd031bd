#include "sylph_core/search/pibt.hpp"

#include <algorithm>

#include "sylph_core/search/swap_rule.hpp"

namespace sylph {

Pibt::Pibt(const Graph& graph, const Vertices& goals, const DistanceTables& distances,
           MotionModel motion)
    : graph_(&graph),
      goals_(goals),
      distances_(&distances),
      motion_(motion),
      now_(static_cast<std::size_t>(graph.size()), kNoAgent),
      next_(static_cast<std::size_t>(graph.size()), kNoAgent) {}

bool Pibt::step(const Vertices& from, const std::vector<AgentId>& order, MoveRanking& ranking,
                Vertices& to) {
  from_ = &from;
  to_ = &to;
  ranking_ = &ranking;
  ranking.observe(from);
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    now_[from[agent]] = static_cast<AgentId>(agent);
  }
  const bool found =
      bindAgents(from, to) && std::all_of(order.begin(), order.end(), [&](const AgentId agent) {
        return to[agent] != kNoVertex || choose(agent);
      });
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    now_[from[agent]] = kNoAgent;
    next_[from[agent]] = kNoAgent;
    if (to[agent] != kNoVertex) {
      next_[to[agent]] = kNoAgent;
    }
  }
  return found;
}

bool Pibt::bindAgents(const Vertices& from, const Vertices& to) {
  for (std::size_t index = 0; index < from.size(); ++index) {
    const auto agent = static_cast<AgentId>(index);
    if (to[agent] == kNoVertex) {
      continue;
    }
    if (next_[to[agent]] != kNoAgent) {
      return false;
    }
    next_[to[agent]] = agent;
  }
  for (std::size_t index = 0; index < from.size(); ++index) {
    const auto agent = static_cast<AgentId>(index);
    if (to[agent] != kNoVertex && to[agent] != from[agent] && closesRing(agent, to[agent])) {
      return false;
    }
  }
  return true;
}

// Follows whoever leaves the vertex that is entered. A ring can only come about by the last of its
// moves to be decided, so that asking this before each move keeps all rings out; with rotations
// only the ring of two, a swap, is refused.
bool Pibt::closesRing(AgentId agent, VertexId target) const {
  const VertexId home = (*from_)[agent];
  AgentId other = now_[target];
  while (other != kNoAgent) {
    const VertexId next = (*to_)[other];
    if (next == home) {
      return true;
    }
    if (motion_.rotations || next == kNoVertex || next == (*from_)[other]) {
      return false;
    }
    other = now_[next];
  }
  return false;
}

bool Pibt::choose(AgentId agent) {
  const VertexId at = (*from_)[agent];
  Moves moves;
  for (const VertexId target : graph_->neighbors(at)) {
    moves.targets[moves.count++] = target;
  }
  moves.targets[moves.count++] = at;
  ranking_->rank(agent, at, moves);
  const AgentId swap_partner = findSwapPartner(agent, moves);
  if (swap_partner != kNoAgent) {
    std::reverse(moves.targets.begin(), moves.targets.begin() + moves.count);
  }
  for (int index = 0; index < moves.count; ++index) {
    const VertexId target = moves.targets[index];
    if (next_[target] != kNoAgent || (target != at && closesRing(agent, target))) {
      continue;
    }
    next_[target] = agent;
    (*to_)[agent] = target;
    const AgentId occupant = now_[target];
    if (occupant != kNoAgent && occupant != agent && (*to_)[occupant] == kNoVertex &&
        !choose(occupant)) {
      continue;
    }
    if (index == 0 && swap_partner != kNoAgent) {
      pull(swap_partner, agent);
    }
    return true;
  }
  next_[at] = agent;
  (*to_)[agent] = at;
  return false;
}

void Pibt::pull(AgentId agent, AgentId into_place_of) {
  const VertexId place = (*from_)[into_place_of];
  if ((*to_)[agent] == kNoVertex && next_[place] == kNoAgent && !closesRing(agent, place)) {
    next_[place] = agent;
    (*to_)[agent] = place;
  }
}

// Two agents that want past each other in a corridor: one has to back out to a junction and pull
// the other along. An agent that backs out chooses its moves in reverse order.
AgentId Pibt::findSwapPartner(AgentId agent, const Moves& moves) const {
  const VertexId at = (*from_)[agent];
  const VertexId wish = moves.targets[0];
  if (wish == at) {
    return kNoAgent;
  }
  const AgentId ahead = now_[wish];
  if (ahead != kNoAgent && (*to_)[ahead] == kNoVertex && haveToSwap(agent, ahead, at, wish)) {
    return ahead;
  }
  // One step before it shows: a neighbour would have to swap with this agent once it is on `wish`.
  for (const VertexId beside : graph_->neighbors(at)) {
    const AgentId other = now_[beside];
    if (other != kNoAgent && beside != wish && haveToSwap(other, agent, at, wish)) {
      return other;
    }
  }
  return kNoAgent;
}

bool Pibt::haveToSwap(AgentId pusher, AgentId puller, VertexId from, VertexId to) const {
  const auto toGo = [this](AgentId agent, VertexId at) { return distances_->get(agent, at); };
  const auto ways = [this](VertexId at, VertexId back, VertexId& onward) {
    return waysOn(at, back, onward);
  };
  return mustSwap(toGo, ways, pusher, puller, from, to) && canSwap(ways, to, from);
}

// Number of ways on from a vertex, without the way back and without dead ends whose agent is home.
int Pibt::waysOn(VertexId at, VertexId back, VertexId& onward) const {
  int ways = 0;
  for (const VertexId vertex : graph_->neighbors(at)) {
    const AgentId occupant = now_[vertex];
    const bool is_closed = graph_->neighbors(vertex).count() == 1 && occupant != kNoAgent &&
                           goals_[occupant] == vertex;
    if (vertex != back && !is_closed) {
      ++ways;
      onward = vertex;
    }
  }
  return ways;
}

}  // namespace sylph
