#include "sylph_core/search/graph.hpp"

#include "sylph_core/grid/action.hpp"

namespace sylph {

std::uint64_t hashOf(const Vertices& configuration) {
  // Constants of the finalizer of MurmurHash3: configurations that differ in one agent must not
  // share low bits, as they would by adding up.
  std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
  for (const VertexId vertex : configuration) {
    hash = (hash ^ static_cast<std::uint64_t>(vertex)) * 0xff51afd7ed558ccdULL;
    hash ^= hash >> 32;
  }
  return hash;
}

Graph::Graph(const Grid& grid) : rows_(grid.rows()), cols_(grid.cols()), cells_(grid.freeCells()) {
  vertices_.assign(static_cast<std::size_t>(grid.size()), kNoVertex);
  for (std::size_t vertex = 0; vertex < cells_.size(); ++vertex) {
    vertices_[static_cast<std::size_t>(grid.indexOf(cells_[vertex]))] =
        static_cast<VertexId>(vertex);
  }
  // Neighbours of all vertices in one array: the searches spend most of their time here.
  offsets_.reserve(cells_.size() + 1);
  targets_.reserve(cells_.size() * 4);
  for (const Cell& cell : cells_) {
    offsets_.push_back(targets_.size());
    for (const Action action : {Action::North, Action::East, Action::South, Action::West}) {
      if (grid.isFree(neighbor(cell, action))) {
        targets_.push_back(vertexAt(neighbor(cell, action)));
      }
    }
  }
  offsets_.push_back(targets_.size());
}

Vertices Graph::toVertices(const Configuration& cells) const {
  Vertices vertices;
  vertices.reserve(cells.size());
  for (const Cell& cell : cells) {
    vertices.push_back(vertexAt(cell));
  }
  return vertices;
}

Configuration Graph::toCells(const Vertices& vertices) const {
  Configuration cells;
  cells.reserve(vertices.size());
  for (const VertexId vertex : vertices) {
    cells.push_back(cellAt(vertex));
  }
  return cells;
}

Plan Graph::toPlan(const std::vector<Vertices>& configurations) const {
  Plan plan;
  plan.reserve(configurations.size());
  for (const Vertices& vertices : configurations) {
    plan.push_back(toCells(vertices));
  }
  return plan;
}

}  // namespace sylph
