#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Vertices of one agent by timestep, start first; the agent rests on the last one.
using VertexPath = Vertices;

/// Where the cells of a graph lie in rows of bits: row by row, with at least one bit that is no
/// cell between two rows, so that a shift of the whole row of bits is a move of all cells at once.
struct BitLayout {
  explicit BitLayout(const Graph& graph);

  std::uint32_t bitOf(VertexId vertex) const { return bits[static_cast<std::size_t>(vertex)]; }

  int stride;                       ///< bits from one row to the next, no multiple of 64
  int words;                        ///< of 64 bits, for all rows
  std::vector<std::uint32_t> bits;  ///< per vertex
};

/// Who is where and when: the paths of all agents that are fixed, as a search for one more path
/// needs them.
///
/// One layer per timestep t holds, as rows of bits, the cells that cannot be entered, because they
/// are no free cells or because an agent is there at t, and for each direction the cells that
/// cannot be entered by that move between t - 1 and t. Those are the moves that would close a ring
/// of agents that all move: agents that follow each other between t - 1 and t form chains, and
/// whoever goes from the vertex that the head of a chain enters to the vertex that its tail leaves
/// closes it. A chain of one agent gives the swap. With rotations only swaps are kept out.
class ReservationTable {
 public:
  enum Direction { kNorth, kEast, kSouth, kWest };

  /// @param horizon  last timestep, > 0; no path may be longer
  /// @param graph    must outlive this object
  ReservationTable(const Graph& graph, MotionModel motion, int agents, int horizon);

  /// The path must not collide with those inserted. It ends at or before the horizon.
  void insert(AgentId agent, const VertexPath& path);
  void remove(AgentId agent);

  /// The path of an inserted agent, empty for others.
  const VertexPath& path(AgentId agent) const { return paths_[static_cast<std::size_t>(agent)]; }
  VertexId position(AgentId agent, Timestep timestep) const {
    const VertexPath& path = paths_[static_cast<std::size_t>(agent)];
    const auto last = static_cast<Timestep>(path.size()) - 1;
    return path[static_cast<std::size_t>(timestep < last ? timestep : last)];
  }
  AgentId occupant(VertexId vertex, Timestep timestep) const {
    return occupants_[static_cast<std::size_t>(timestep) * vertex_count_ +
                      static_cast<std::size_t>(vertex)];
  }
  /// The timestep from which on nobody is on a vertex any more, horizon + 1 if never.
  Timestep freeFrom(VertexId vertex) const;

  /// Whether a move between adjacent vertices closes no ring. Says nothing on who is on `to`.
  bool isOpen(VertexId from, VertexId to, Timestep arrival) const;

  int horizon() const { return horizon_; }
  const BitLayout& layout() const { return layout_; }
  /// Words of cells that cannot be entered at a timestep.
  const std::uint64_t* closed(Timestep timestep) const { return layer(timestep); }
  /// Words of cells that cannot be entered at a timestep, > 0, by a move in a direction.
  const std::uint64_t* closedTo(Direction direction, Timestep timestep) const {
    return layer(timestep) + (1 + direction) * layout_.words;
  }

 private:
  static constexpr int kRowsPerLayer = 5;

  const std::uint64_t* layer(Timestep timestep) const {
    return layers_.data() + static_cast<std::size_t>(timestep) *
                                static_cast<std::size_t>(kRowsPerLayer * layout_.words);
  }
  std::uint64_t* layer(Timestep timestep) {
    return layers_.data() + static_cast<std::size_t>(timestep) *
                                static_cast<std::size_t>(kRowsPerLayer * layout_.words);
  }
  AgentId& occupantRef(VertexId vertex, Timestep timestep) {
    return occupants_[static_cast<std::size_t>(timestep) * vertex_count_ +
                      static_cast<std::size_t>(vertex)];
  }
  void noteMove(VertexId from, VertexId to, Timestep arrival, bool is_inserted);
  VertexId headOf(VertexId vertex, Timestep arrival) const;
  VertexId tailOf(VertexId vertex, Timestep arrival) const;
  void setClosedTo(VertexId from, VertexId to, Timestep arrival, bool is_closed);
  int directionOf(VertexId from, VertexId to) const;

  BitLayout layout_;
  MotionModel motion_;
  int horizon_;
  std::size_t vertex_count_;
  std::vector<std::uint64_t> layers_;
  std::vector<AgentId> occupants_;
  std::vector<VertexPath> paths_;
};

}  // namespace sylph
