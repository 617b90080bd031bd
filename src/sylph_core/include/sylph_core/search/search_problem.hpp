#pragma once

#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/search/distance_tables.hpp"
#include "sylph_core/search/graph.hpp"

namespace sylph {

/// An instance in the form in which the searches take it.
struct SearchProblem {
  /// @param instance  its grid must outlive this object
  explicit SearchProblem(const Instance& instance)
      : graph(instance.grid),
        starts(graph.toVertices(instance.starts)),
        goals(graph.toVertices(instance.goals)),
        motion(instance.motion),
        distances(instance.grid, graph, instance.goals) {}

  // The distance tables refer to the graph.
  SearchProblem(const SearchProblem&) = delete;
  SearchProblem& operator=(const SearchProblem&) = delete;

  int agentCount() const { return static_cast<int>(starts.size()); }

  Graph graph;
  Vertices starts;           ///< of every agent
  Vertices goals;            ///< of every agent
  MotionModel motion;        ///< whether agents may rotate
  DistanceTables distances;  ///< to each goal, worked out where the search asks
};

}  // namespace sylph
