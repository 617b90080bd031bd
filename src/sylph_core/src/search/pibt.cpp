#include "sylph_core/search/pibt.hpp"

#include <algorithm>

#include "sylph_core/policy/swap_rule.hpp"

namespace sylph {

Pibt::Pibt(const SearchProblem& problem)
    : graph_(&problem.graph),
      goals_(&problem.goals),
      distances_(&problem.distances),
      motion_(problem.motion),
      occupied_now_(static_cast<std::size_t>(problem.graph.size()), kNoAgent),
      occupied_next_(static_cast<std::size_t>(problem.graph.size()), kNoAgent) {}

bool Pibt::step(const Vertices& from, const std::vector<AgentId>& order, MoveRanking& ranking,
                Vertices& to) {
  from_ = &from;
  to_ = &to;
  ranking_ = &ranking;
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    occupied_now_[from[agent]] = static_cast<AgentId>(agent);
  }
  const bool found =
      bindAgents(from, to) && std::all_of(order.begin(), order.end(), [&](const AgentId agent) {
        return to[agent] != kNoVertex || choose(agent);
      });
  // Only what this step has touched: clearing whole maps would cost more than the step itself.
  for (std::size_t agent = 0; agent < from.size(); ++agent) {
    occupied_now_[from[agent]] = kNoAgent;
    occupied_next_[from[agent]] = kNoAgent;
    if (to[agent] != kNoVertex) {
      occupied_next_[to[agent]] = kNoAgent;
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
    if (occupied_next_[to[agent]] != kNoAgent) {
      return false;
    }
    occupied_next_[to[agent]] = agent;
  }
  for (std::size_t index = 0; index < from.size(); ++index) {
    const auto agent = static_cast<AgentId>(index);
    if (to[agent] != kNoVertex && to[agent] != from[agent] && closesRotation(agent, to[agent])) {
      return false;
    }
  }
  return true;
}

// Follows the agent that leaves the vertex which is entered. A rotation can only come about by the
// last of its moves to be settled, so that asking this before each move keeps all rotations out;
// where they are allowed only that of two agents, a swap, is refused.
bool Pibt::closesRotation(AgentId agent, VertexId target) const {
  const VertexId home = (*from_)[agent];
  AgentId other = occupied_now_[target];
  while (other != kNoAgent) {
    const VertexId next = (*to_)[other];
    if (next == home) {
      return true;
    }
    if (motion_.rotations || next == kNoVertex || next == (*from_)[other]) {
      return false;
    }
    other = occupied_now_[next];
  }
  return false;
}

// The procedure PIBT(a_i, a_j) of Alg. 1. Needs no a_j: the check for a swap sees it by its settled
// move. An agent that returns false stays, and the one that it inherits its priority from tries
// its next move.
bool Pibt::choose(AgentId agent) {
  const VertexId at = (*from_)[agent];
  Moves moves = movesFrom(*graph_, at);
  ranking_->rank(agent, at, occupied_now_, moves);
  const AgentId swap_partner = findSwapPartner(agent, moves);
  if (swap_partner != kNoAgent) {
    std::reverse(moves.targets.begin(), moves.targets.begin() + moves.count);
  }
  for (int index = 0; index < moves.count; ++index) {
    const VertexId target = moves.targets[index];
    // Vertex conflict, or swap or rotation.
    if (occupied_next_[target] != kNoAgent || (target != at && closesRotation(agent, target))) {
      continue;
    }
    occupied_next_[target] = agent;
    (*to_)[agent] = target;
    // Priority inheritance: who is in the way chooses next, before agents that have a higher
    // priority than its own.
    const AgentId occupant = occupied_now_[target];
    if (occupant != kNoAgent && occupant != agent && (*to_)[occupant] == kNoVertex &&
        !choose(occupant)) {
      continue;
    }
    if (index == 0 && swap_partner != kNoAgent) {
      pull(swap_partner, agent);
    }
    return true;
  }
  occupied_next_[at] = agent;
  (*to_)[agent] = at;
  return false;
}

void Pibt::pull(AgentId agent, AgentId into_place_of) {
  const VertexId place = (*from_)[into_place_of];
  if ((*to_)[agent] == kNoVertex && occupied_next_[place] == kNoAgent &&
      !closesRotation(agent, place)) {
    occupied_next_[place] = agent;
    (*to_)[agent] = place;
  }
}

// Two agents that have to pass each other in a corridor: one backs out to a junction and pulls the
// other along. An agent that backs out tries its moves in reverse order.
AgentId Pibt::findSwapPartner(AgentId agent, const Moves& moves) const {
  const VertexId at = (*from_)[agent];
  const VertexId desired = moves.targets[0];
  if (desired == at) {
    return kNoAgent;
  }
  const AgentId ahead = occupied_now_[desired];
  if (ahead != kNoAgent && (*to_)[ahead] == kNoVertex && haveToSwap(agent, ahead, at, desired)) {
    return ahead;
  }
  // One step before it shows: a neighbour would have to swap with this agent once that is on
  // `desired`.
  for (const VertexId beside : graph_->neighbors(at)) {
    const AgentId other = occupied_now_[beside];
    if (other != kNoAgent && beside != desired && haveToSwap(other, agent, at, desired)) {
      return other;
    }
  }
  return kNoAgent;
}

bool Pibt::haveToSwap(AgentId pusher, AgentId puller, VertexId from, VertexId to) const {
  const auto toGo = [this](AgentId agent, VertexId at) { return distances_->get(agent, at); };
  const auto ways = [this](VertexId at, VertexId back, VertexId& onward) {
    return countWaysOn(at, back, onward);
  };
  return mustSwap(toGo, ways, pusher, puller, from, to) && canSwap(ways, to, from);
}

// Number of ways on from a vertex, without the way back and without dead ends whose agent is on its
// goal and would have to come out for others.
int Pibt::countWaysOn(VertexId at, VertexId back, VertexId& onward) const {
  int ways = 0;
  for (const VertexId vertex : graph_->neighbors(at)) {
    const AgentId occupant = occupied_now_[vertex];
    const bool is_closed = graph_->neighbors(vertex).count() == 1 && occupant != kNoAgent &&
                           (*goals_)[occupant] == vertex;
    if (vertex != back && !is_closed) {
      ++ways;
      onward = vertex;
    }
  }
  return ways;
}

}  // namespace sylph
