#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/paths.hpp"

namespace sylph {

/// Where the cells of a graph lie in rows of bits: row by row, with at least one bit that is no
/// cell between two rows, so that a shift of the whole row of bits is a move of all cells at once.
struct BitLayout {
  /// Leaves room for one cell more in each row.
  explicit BitLayout(const Graph& graph);

  /// Index of a vertex in a row of bits.
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
/// cannot be entered by that move between t - 1 and t, because that would be a swap.
///
/// Longer rotations are rare, and which move would close one depends on all agents that move in a
/// chain. They are therefore looked for in a path that was found (rotationClosedBy()), and the move
/// is closed by hand (setClosedTo()) before the path is searched again.
class ReservationTable {
 public:
  /// Of a move, in the order of the rows of a layer.
  enum Direction { North, East, South, West };

  /// @param horizon  last timestep, > 0; no path may be longer
  /// @param graph    must outlive this object
  ReservationTable(const Graph& graph, MotionModel motion, int agents, int horizon);

  /// Memory of a table, without the paths.
  static double bytesOf(const Graph& graph, int horizon);

  /// The path must not collide with those inserted. It ends at or before the horizon.
  void insert(AgentId agent, const VertexPath& path);
  /// Takes an inserted agent out again.
  void remove(AgentId agent);

  /// The path of an inserted agent, empty for others.
  const VertexPath& path(AgentId agent) const { return paths_[static_cast<std::size_t>(agent)]; }
  /// Where an inserted agent is: on its last vertex once it has arrived.
  VertexId position(AgentId agent, Timestep timestep) const {
    const VertexPath& path = paths_[static_cast<std::size_t>(agent)];
    const auto last = static_cast<Timestep>(path.size()) - 1;
    return path[static_cast<std::size_t>(timestep < last ? timestep : last)];
  }
  /// The inserted agent on a vertex, kNoAgent if there is none.
  AgentId occupant(VertexId vertex, Timestep timestep) const {
    return occupants_[slotOf(vertex, timestep)];
  }
  /// The timestep from which on no agent is on a vertex any more, horizon + 1 if never.
  Timestep freeFrom(VertexId vertex) const;

  /// Whether a move between adjacent vertices is closed. Says nothing on who is on `to`.
  bool isClosedTo(VertexId from, VertexId to, Timestep arrival) const {
    return (layers_[wordOf(from, to, arrival)] & maskOf(to)) != 0;
  }
  /// Closes a move between adjacent vertices or opens it again.
  void setClosedTo(VertexId from, VertexId to, Timestep arrival, bool is_closed);

  /// The first arrival with which a path closes a rotation of agents, those inserted and
  /// the one on the path; 0 if there is none. With rotations there never is one.
  Timestep rotationClosedBy(const VertexPath& path) const;

  /// The last timestep.
  int horizon() const { return horizon_; }
  /// Of the rows of bits.
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
  std::size_t slotOf(VertexId vertex, Timestep timestep) const {
    return static_cast<std::size_t>(vertex) * static_cast<std::size_t>(horizon_ + 1) +
           static_cast<std::size_t>(timestep);
  }
  std::uint64_t maskOf(VertexId vertex) const {
    return std::uint64_t{1} << (layout_.bitOf(vertex) % 64);
  }
  std::size_t wordOf(VertexId from, VertexId to, Timestep arrival) const;
  void setSwapsClosed(const VertexPath& path, bool is_closed);

  BitLayout layout_;
  MotionModel motion_;
  int horizon_;
  std::vector<std::uint64_t> layers_;
  std::vector<AgentId> occupants_;  // vertex by vertex, since agents rest for long
  std::vector<VertexPath> paths_;
};

}  // namespace sylph
