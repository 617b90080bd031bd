#pragma once

#include <cstdint>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/graph.hpp"
#include "sylph_core/search/reservation_table.hpp"

namespace sylph {

/// Finds the path of one agent that arrives first among paths fixed in a reservation table.
///
/// Breadth-first search over time in which the set of cells that can be reached is a row of bits:
/// one timestep costs a few operations per 64 cells, however crowded the map is. That is the same
/// search as A* in space and time with a perfect tie-break, only that nothing is queued.
class PathSearch {
 public:
  /// @param graph must outlive this object
  explicit PathSearch(const Graph& graph) : graph_(&graph) {}

  /// A path from `start` at timestep 0 that arrives on `goal` for good as early as possible, and
  /// by `latest_arrival`; one of those at random.
  /// @param table  unchanged in the end; in between, moves that close a rotation are closed in it
  /// @return empty if there is none, or if the time was over before one was found
  VertexPath find(ReservationTable& table, VertexId start, VertexId goal, Timestep latest_arrival,
                  const Deadline& deadline, Rng& rng);

 private:
  Timestep spread(const ReservationTable& table, VertexId start, VertexId goal,
                  Timestep latest_arrival, const Deadline& deadline);
  VertexPath trace(const ReservationTable& table, VertexId goal, Timestep arrival, Rng& rng) const;
  bool isReached(const BitLayout& layout, VertexId vertex, Timestep timestep) const;

  const Graph* graph_;
  int margin_ = 0;                      // words of zeros around each row of bits
  std::vector<std::uint64_t> reached_;  // row of bits per timestep
};

}  // namespace sylph
