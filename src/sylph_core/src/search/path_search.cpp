#include "sylph_core/search/path_search.hpp"

#include <algorithm>
#include <array>

namespace sylph {
namespace {

constexpr int kBitsPerWord = 64;
/// On large maps one search takes seconds; so many words are spread within microseconds.
constexpr long kWordsBetweenClockReads = 1L << 15;

// The cells reached one timestep later. `from` has margins of zeros that shifts may read.
void spreadOnce(const std::uint64_t* from, std::uint64_t* to, const ReservationTable& table,
                Timestep arrival) {
  const BitLayout& layout = table.layout();
  const int words = layout.words;
  const int skip = layout.stride / kBitsPerWord;
  const int shift = layout.stride % kBitsPerWord;
  const std::uint64_t* closed = table.closed(arrival);
  const std::uint64_t* to_north = closed + words * (1 + ReservationTable::North);
  const std::uint64_t* to_east = closed + words * (1 + ReservationTable::East);
  const std::uint64_t* to_south = closed + words * (1 + ReservationTable::South);
  const std::uint64_t* to_west = closed + words * (1 + ReservationTable::West);
  for (int word = 0; word < words; ++word) {
    const std::uint64_t* here = from + word;
    const std::uint64_t east = here[0] << 1 | here[-1] >> (kBitsPerWord - 1);
    const std::uint64_t west = here[0] >> 1 | here[1] << (kBitsPerWord - 1);
    const std::uint64_t south = here[-skip] << shift | here[-skip - 1] >> (kBitsPerWord - shift);
    const std::uint64_t north = here[skip] >> shift | here[skip + 1] << (kBitsPerWord - shift);
    to[word] = ~closed[word] & (here[0] | (east & ~to_east[word]) | (west & ~to_west[word]) |
                                (south & ~to_south[word]) | (north & ~to_north[word]));
  }
}

}  // namespace

VertexPath PathSearch::find(ReservationTable& table, VertexId start, VertexId goal,
                            Timestep latest_arrival, const Deadline& deadline, Rng& rng) {
  struct Closing {
    VertexId from;
    VertexId to;
    Timestep arrival;
  };
  std::vector<Closing> closings;
  VertexPath path;
  // A path that closes a rotation shows only when it is whole: then that move is forbidden and the
  // search begins again.
  while (true) {
    const Timestep arrival =
        spread(table, start, goal, std::min(latest_arrival, table.horizon()), deadline);
    path = arrival < 0 ? VertexPath() : trace(table, goal, arrival, rng);
    const Timestep rotation = table.rotationClosedBy(path);
    if (rotation == 0) {
      break;
    }
    closings.push_back({path[rotation - 1], path[rotation], rotation});
    table.setClosedTo(path[rotation - 1], path[rotation], rotation, true);
  }
  for (const Closing& closing : closings) {
    table.setClosedTo(closing.from, closing.to, closing.arrival, false);
  }
  return path;
}

// @return the first timestep at which the agent can be on its goal for good, -1 if there is none or
// no time to find it
Timestep PathSearch::spread(const ReservationTable& table, VertexId start, VertexId goal,
                            Timestep latest_arrival, const Deadline& deadline) {
  const Timestep goal_free_from = table.freeFrom(goal);
  // It has to rest there for good, so others must have passed over its goal before.
  if (goal_free_from > latest_arrival) {
    return -1;
  }
  const BitLayout& layout = table.layout();
  margin_ = layout.stride / kBitsPerWord + 2;
  const auto row = static_cast<std::size_t>(layout.words + 2 * margin_);
  const std::size_t needed = row * static_cast<std::size_t>(table.horizon() + 1);
  // Kept from search to search: to allocate and clear it takes longer than many searches do.
  if (reached_.size() < needed) {
    reached_.assign(needed, 0);
  }
  std::uint64_t* reached = reached_.data() + margin_;
  std::fill(reached, reached + layout.words, 0);
  const std::uint32_t start_bit = layout.bitOf(start);
  if ((table.closed(0)[start_bit / kBitsPerWord] >> (start_bit % kBitsPerWord) & 1) != 0) {
    return -1;
  }
  reached[start_bit / kBitsPerWord] |= std::uint64_t{1} << (start_bit % kBitsPerWord);
  long words_spread = 0;
  for (Timestep timestep = 0; timestep <= latest_arrival; ++timestep) {
    if (timestep >= goal_free_from && isReached(layout, goal, timestep)) {
      return timestep;
    }
    if (timestep < latest_arrival) {
      spreadOnce(reached, reached + row, table, timestep + 1);
      reached += row;
      words_spread += layout.words;
    }
    if (words_spread >= kWordsBetweenClockReads) {
      words_spread = 0;
      if (deadline.isOver()) {
        return -1;
      }
    }
  }
  return -1;
}

bool PathSearch::isReached(const BitLayout& layout, VertexId vertex, Timestep timestep) const {
  const auto row = static_cast<std::size_t>(layout.words + 2 * margin_);
  const std::uint32_t bit = layout.bitOf(vertex);
  return (reached_[static_cast<std::size_t>(timestep) * row + margin_ + bit / kBitsPerWord] >>
              (bit % kBitsPerWord) &
          1) != 0;
}

VertexPath PathSearch::trace(const ReservationTable& table, VertexId goal, Timestep arrival,
                             Rng& rng) const {
  const BitLayout& layout = table.layout();
  VertexPath path(static_cast<std::size_t>(arrival) + 1, goal);
  VertexId vertex = goal;
  for (Timestep timestep = arrival; timestep > 0; --timestep) {
    // Any of the paths that arrive as early is as cheap for this agent; a random one leaves others
    // room in other places each time.
    std::array<VertexId, 5> origins{};
    std::size_t count = 0;
    if (isReached(layout, vertex, timestep - 1)) {
      origins[count++] = vertex;
    }
    for (const VertexId origin : graph_->neighbors(vertex)) {
      if (isReached(layout, origin, timestep - 1) && !table.isClosedTo(origin, vertex, timestep)) {
        origins[count++] = origin;
      }
    }
    vertex = count == 1 ? origins[0] : origins[drawIndex(rng, count)];
    path[static_cast<std::size_t>(timestep) - 1] = vertex;
  }
  return path;
}

}  // namespace sylph
