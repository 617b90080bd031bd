#pragma once

#include <cstdint>
#include <vector>

#include "sylph_core/grid/grid.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

using VertexId = std::int32_t;  ///< index of a free cell in its graph, from 0

constexpr VertexId kNoVertex = -1;  ///< as yet unknown, or an obstacle
constexpr AgentId kNoAgent = -1;    ///< nobody is there

/// A configuration as the searches see it: the vertex of every agent.
using Vertices = std::vector<VertexId>;

/// The same on every computer; equal configurations have equal ones.
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

  /// Vertices in row-major order of their cells.
  explicit Graph(const Grid& grid);

  /// Number of vertices.
  int size() const { return static_cast<int>(cells_.size()); }

  /// Free cells beside that of a vertex, without itself.
  Neighbors neighbors(VertexId vertex) const {
    const auto index = static_cast<std::size_t>(vertex);
    return {targets_.data() + offsets_[index], targets_.data() + offsets_[index + 1]};
  }

  /// The vertex of a cell inside the grid, kNoVertex on obstacles.
  VertexId vertexAt(const Cell& cell) const {
    return vertices_[static_cast<std::size_t>(cell.row * cols_ + cell.col)];
  }
  /// The cell of a vertex.
  const Cell& cellAt(VertexId vertex) const { return cells_[static_cast<std::size_t>(vertex)]; }
  /// Row-major index of the cell in the grid.
  int indexAt(VertexId vertex) const { return cellAt(vertex).row * cols_ + cellAt(vertex).col; }

  /// Vertex by vertex, as vertexAt().
  Vertices toVertices(const Configuration& cells) const;
  /// Cell by cell, as cellAt().
  Configuration toCells(const Vertices& vertices) const;
  /// Configuration by configuration, as toCells().
  Plan toPlan(const std::vector<Vertices>& configurations) const;

  /// Of the grid.
  int rows() const { return rows_; }
  /// Of the grid.
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
