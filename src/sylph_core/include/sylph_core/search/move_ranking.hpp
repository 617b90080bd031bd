#pragma once

#include <array>
#include <vector>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// The vertices an agent can be on at the next timestep: its neighbours and its own.
struct Moves {
  std::array<VertexId, 5> targets{};  ///< the first `count` hold
  int count = 0;                      ///< 1 ... 5
};

/// The moves of an agent, in the order of Graph::neighbors(), its own vertex last.
Moves movesFrom(const Graph& graph, VertexId at);

/// Sorts moves by their keys, the least first; equal ones keep their order.
/// @param key  of a target
template <typename Key>
void sortMoves(Moves& moves, Key key) {
  using Value = decltype(key(VertexId{}));
  std::array<Value, 5> keys{};
  for (int index = 0; index < moves.count; ++index) {
    const VertexId target = moves.targets[index];
    const Value own = key(target);
    int slot = index;
    for (; slot > 0 && keys[slot - 1] > own; --slot) {
      keys[slot] = keys[slot - 1];
      moves.targets[slot] = moves.targets[slot - 1];
    }
    keys[slot] = own;
    moves.targets[slot] = target;
  }
}

/// Per vertex the agent on it, kNoAgent where there is none.
using Occupants = std::vector<AgentId>;

/// The order in which an agent tries its moves. PIBT takes care of everything else.
class MoveRanking {
 public:
  virtual ~MoveRanking() = default;

  /// Brings the moves of one agent into the order of its preference, best first.
  virtual void rank(AgentId agent, VertexId at, const Occupants& occupied_now, Moves& moves) = 0;
};

}  // namespace sylph
