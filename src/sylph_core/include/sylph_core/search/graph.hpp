#pragma once

#include <cstdint>
#include <vector>

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

using VertexId = std::int32_t;  ///< index of a free cell in its graph, from 0

constexpr VertexId kNoVertex = -1;
constexpr AgentId kNoAgent = -1;

/// A configuration as the searches see it: the vertex of every agent.
using Vertices = std::vector<VertexId>;

std::uint64_t hashOf(const Vertices& configuration);

/// The free cells of a grid as a 4-connected graph, compact enough to search in.
class Graph {
 public:
  /// Neighbours of one vertex in the order North, East, South, West.
  class Neighbors {
   public:
    Neighbors(const VertexId* first, const VertexId* last) : first_(first), last_(last) {}
    const VertexId* begin() const { return first_; }
    const VertexId* end() const { return last_; }
    int count() const { return static_cast<int>(last_ - first_); }

   private:
    const VertexId* first_;
    const VertexId* last_;
  };

  explicit Graph(const Grid& grid);

  /// Number of vertices.
  int size() const { return static_cast<int>(cells_.size()); }

  Neighbors neighbors(VertexId vertex) const {
    const auto index = static_cast<std::size_t>(vertex);
    return {targets_.data() + offsets_[index], targets_.data() + offsets_[index + 1]};
  }

  /// The vertex of a cell inside the grid, kNoVertex on obstacles.
  VertexId vertexAt(const Cell& cell) const {
    return vertices_[static_cast<std::size_t>(cell.row * cols_ + cell.col)];
  }
  const Cell& cellAt(VertexId vertex) const { return cells_[static_cast<std::size_t>(vertex)]; }
  /// Row-major index of the cell in the grid.
  int indexAt(VertexId vertex) const { return cellAt(vertex).row * cols_ + cellAt(vertex).col; }

  Vertices toVertices(const Configuration& cells) const;
  Configuration toCells(const Vertices& vertices) const;
  Plan toPlan(const std::vector<Vertices>& configurations) const;

  int rows() const { return rows_; }
  int cols() const { return cols_; }

 private:
  int rows_;
  int cols_;
  std::vector<Cell> cells_;         // per vertex, row-major
  std::vector<VertexId> vertices_;  // per cell, row-major
  std::vector<std::size_t> offsets_;
  std::vector<VertexId> targets_;
};

}  // namespace sylph
