#include "sylph_core/search/reservation_table.hpp"

#include <algorithm>

namespace sylph {
namespace {

constexpr int kBitsPerWord = 64;

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
      layers_(static_cast<std::size_t>(horizon + 1) *
                  static_cast<std::size_t>(kRowsPerLayer * layout_.words),
              0),
      occupants_(static_cast<std::size_t>(graph.size()) * static_cast<std::size_t>(horizon + 1),
                 kNoAgent),
      paths_(static_cast<std::size_t>(agents)) {
  for (Timestep timestep = 0; timestep <= horizon; ++timestep) {
    std::uint64_t* closed = layer(timestep);
    std::fill(closed, closed + layout_.words, ~std::uint64_t{0});
    for (const std::uint32_t bit : layout_.bits) {
      closed[bit / kBitsPerWord] &= ~(std::uint64_t{1} << (bit % kBitsPerWord));
    }
  }
}

double ReservationTable::bytesOf(const Graph& graph, int horizon) {
  const double words = static_cast<double>(kRowsPerLayer) * BitLayout(graph).words;
  return (horizon + 1.0) *
         (words * sizeof(std::uint64_t) + static_cast<double>(graph.size()) * sizeof(AgentId));
}

void ReservationTable::insert(AgentId agent, const VertexPath& path) {
  paths_[agent] = path;
  for (Timestep timestep = 0; timestep <= horizon_; ++timestep) {
    const VertexId vertex = position(agent, timestep);
    layer(timestep)[layout_.bitOf(vertex) / kBitsPerWord] |= maskOf(vertex);
    occupants_[slotOf(vertex, timestep)] = agent;
  }
  setSwapsClosed(path, true);
}

void ReservationTable::remove(AgentId agent) {
  setSwapsClosed(paths_[agent], false);
  for (Timestep timestep = 0; timestep <= horizon_; ++timestep) {
    const VertexId vertex = position(agent, timestep);
    layer(timestep)[layout_.bitOf(vertex) / kBitsPerWord] &= ~maskOf(vertex);
    occupants_[slotOf(vertex, timestep)] = kNoAgent;
  }
  paths_[agent].clear();
}

void ReservationTable::setSwapsClosed(const VertexPath& path, bool is_closed) {
  for (std::size_t timestep = 1; timestep < path.size(); ++timestep) {
    if (path[timestep - 1] != path[timestep]) {
      setClosedTo(path[timestep], path[timestep - 1], static_cast<Timestep>(timestep), is_closed);
    }
  }
}

std::size_t ReservationTable::wordOf(VertexId from, VertexId to, Timestep arrival) const {
  const auto bit = static_cast<int>(layout_.bitOf(to));
  const int shift = bit - static_cast<int>(layout_.bitOf(from));
  const Direction direction = shift == 1                ? East
                              : shift == -1             ? West
                              : shift == layout_.stride ? South
                                                        : North;
  return static_cast<std::size_t>(arrival) *
             static_cast<std::size_t>(kRowsPerLayer * layout_.words) +
         static_cast<std::size_t>((1 + direction) * layout_.words + bit / kBitsPerWord);
}

void ReservationTable::setClosedTo(VertexId from, VertexId to, Timestep arrival, bool is_closed) {
  std::uint64_t& word = layers_[wordOf(from, to, arrival)];
  word = is_closed ? word | maskOf(to) : word & ~maskOf(to);
}

// Agents that follow each other form a chain, and a move closes a rotation if the agent at the head
// of the chain that it joins enters the vertex that the move leaves. No agent in a chain rests: the
// next one enters its vertex.
Timestep ReservationTable::rotationClosedBy(const VertexPath& path) const {
  if (motion_.rotations) {
    return 0;
  }
  for (std::size_t timestep = 1; timestep < path.size(); ++timestep) {
    const auto arrival = static_cast<Timestep>(timestep);
    const VertexId home = path[timestep - 1];
    VertexId entered = path[timestep];
    while (entered != kNoVertex && entered != home) {
      const AgentId ahead = occupant(entered, arrival - 1);
      entered = ahead == kNoAgent ? kNoVertex : position(ahead, arrival);
    }
    if (entered == home && path[timestep] != home) {
      return arrival;
    }
  }
  return 0;
}

Timestep ReservationTable::freeFrom(VertexId vertex) const {
  Timestep timestep = horizon_ + 1;
  while (timestep > 0 && occupant(vertex, timestep - 1) == kNoAgent) {
    --timestep;
  }
  return timestep;
}

}  // namespace sylph
