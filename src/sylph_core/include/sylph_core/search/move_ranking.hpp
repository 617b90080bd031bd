#pragma once

#include <array>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// The vertices an agent can be on at the next timestep: its neighbours and its own.
struct Moves {
  std::array<VertexId, 5> targets{};
  int count = 0;
};

/// What agents want: the order in which each tries its moves. PIBT takes care of everything else.
class MoveRanking {
 public:
  virtual ~MoveRanking() = default;

  /// Told of a configuration before agents in it are asked, once per PIBT step.
  virtual void observe(const Vertices& configuration) = 0;

  /// Brings the moves of one agent into the order of its preference, best first.
  virtual void rank(AgentId agent, VertexId at, Moves& moves) = 0;
};

}  // namespace sylph
