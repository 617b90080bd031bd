#include "sylph_core/search/move_ranking.hpp"

namespace sylph {

Moves movesFrom(const Graph& graph, VertexId at) {
  Moves moves;
  for (const VertexId target : graph.neighbors(at)) {
    moves.targets[moves.count++] = target;
  }
  moves.targets[moves.count++] = at;
  return moves;
}

}  // namespace sylph
