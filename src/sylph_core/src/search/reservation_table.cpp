#include "sylph_core/search/reservation_table.hpp"

#include <algorithm>

namespace sylph {
namespace {

constexpr int kBitsPerWord = 64;
constexpr int kNoDirection = -1;

std::uint64_t maskOf(std::uint32_t bit) {
  return std::uint64_t{1} << (bit % kBitsPerWord);
}

}  // namespace

BitLayout::BitLayout(const Graph& graph) : stride(graph.cols() + 1) {
  // A stride of whole words would need shifts by a word's width, which C++ leaves undefined.
  stride += stride % kBitsPerWord == 0 ? 1 : 0;
  words = (graph.rows() * stride + kBitsPerWord - 1) / kBitsPerWord;
  bits.reserve(static_cast<std::size_t>(graph.size()));
  for (VertexId vertex = 0; vertex < graph.size(); ++vertex) {
    const Cell& cell = graph.cellAt(vertex);
    bits.push_back(static_cast<std::uint32_t>(cell.row * stride + cell.col));
  }
}

ReservationTable::ReservationTable(const Graph& graph, MotionModel motion, int agents, int horizon)
    : layout_(graph),
      motion_(motion),
      horizon_(horizon),
      vertex_count_(static_cast<std::size_t>(graph.size())),
      layers_(static_cast<std::size_t>(horizon + 1) *
                  static_cast<std::size_t>(kRowsPerLayer * layout_.words),
              0),
      occupants_(static_cast<std::size_t>(horizon + 1) * vertex_count_, kNoAgent),
      paths_(static_cast<std::size_t>(agents)) {
  for (Timestep timestep = 0; timestep <= horizon; ++timestep) {
    std::uint64_t* closed = layer(timestep);
    std::fill(closed, closed + layout_.words, ~std::uint64_t{0});
    for (const std::uint32_t bit : layout_.bits) {
      closed[bit / kBitsPerWord] &= ~maskOf(bit);
    }
  }
}

void ReservationTable::insert(AgentId agent, const VertexPath& path) {
  paths_[agent] = path;
  for (Timestep timestep = 0; timestep <= horizon_; ++timestep) {
    const VertexId vertex = position(agent, timestep);
    const std::uint32_t bit = layout_.bitOf(vertex);
    layer(timestep)[bit / kBitsPerWord] |= maskOf(bit);
    occupantRef(vertex, timestep) = agent;
  }
  for (std::size_t timestep = 1; timestep < path.size(); ++timestep) {
    if (path[timestep - 1] != path[timestep]) {
      noteMove(path[timestep - 1], path[timestep], static_cast<Timestep>(timestep), true);
    }
  }
}

void ReservationTable::remove(AgentId agent) {
  const VertexPath& path = paths_[agent];
  for (std::size_t timestep = 1; timestep < path.size(); ++timestep) {
    if (path[timestep - 1] != path[timestep]) {
      noteMove(path[timestep - 1], path[timestep], static_cast<Timestep>(timestep), false);
    }
  }
  for (Timestep timestep = 0; timestep <= horizon_; ++timestep) {
    const VertexId vertex = position(agent, timestep);
    const std::uint32_t bit = layout_.bitOf(vertex);
    layer(timestep)[bit / kBitsPerWord] &= ~maskOf(bit);
    occupantRef(vertex, timestep) = kNoAgent;
  }
  paths_[agent].clear();
}

// A move joins the chain ahead of it and the chain behind it; without it they are two again.
void ReservationTable::noteMove(VertexId from, VertexId to, Timestep arrival, bool is_inserted) {
  if (motion_.rotations) {
    setClosedTo(to, from, arrival, is_inserted);
    return;
  }
  const VertexId head = headOf(to, arrival);
  const VertexId tail = tailOf(from, arrival);
  if (head != to) {
    setClosedTo(head, to, arrival, !is_inserted);
  }
  if (tail != from) {
    setClosedTo(from, tail, arrival, !is_inserted);
  }
  setClosedTo(head, tail, arrival, is_inserted);
}

// The vertex that the first of a chain enters, from a vertex that the chain leaves.
VertexId ReservationTable::headOf(VertexId vertex, Timestep arrival) const {
  AgentId leaving = occupant(vertex, arrival - 1);
  while (leaving != kNoAgent) {
    vertex = position(leaving, arrival);
    leaving = occupant(vertex, arrival - 1);
  }
  return vertex;
}

// The vertex that the last of a chain leaves, from a vertex that the chain enters.
VertexId ReservationTable::tailOf(VertexId vertex, Timestep arrival) const {
  AgentId entering = occupant(vertex, arrival);
  while (entering != kNoAgent) {
    vertex = position(entering, arrival - 1);
    entering = occupant(vertex, arrival);
  }
  return vertex;
}

// kNoDirection unless the vertices are adjacent.
int ReservationTable::directionOf(VertexId from, VertexId to) const {
  const int shift = static_cast<int>(layout_.bitOf(to)) - static_cast<int>(layout_.bitOf(from));
  if (shift == 1) {
    return kEast;
  }
  if (shift == -1) {
    return kWest;
  }
  if (shift == layout_.stride) {
    return kSouth;
  }
  return shift == -layout_.stride ? kNorth : kNoDirection;
}

void ReservationTable::setClosedTo(VertexId from, VertexId to, Timestep arrival, bool is_closed) {
  const int direction = directionOf(from, to);
  if (direction == kNoDirection) {
    return;
  }
  const std::uint32_t bit = layout_.bitOf(to);
  std::uint64_t& word = layer(arrival)[(1 + direction) * layout_.words + bit / kBitsPerWord];
  word = is_closed ? word | maskOf(bit) : word & ~maskOf(bit);
}

bool ReservationTable::isOpen(VertexId from, VertexId to, Timestep arrival) const {
  const std::uint32_t bit = layout_.bitOf(to);
  const std::uint64_t* row = layer(arrival) + (1 + directionOf(from, to)) * layout_.words;
  return (row[bit / kBitsPerWord] & maskOf(bit)) == 0;
}

Timestep ReservationTable::freeFrom(VertexId vertex) const {
  Timestep timestep = horizon_ + 1;
  while (timestep > 0 && occupant(vertex, timestep - 1) == kNoAgent) {
    --timestep;
  }
  return timestep;
}

}  // namespace sylph
