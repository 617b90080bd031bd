#pragma once

#include <vector>

#include "sylph_core/search/graph.hpp"

namespace sylph {

/// Vertices of one agent by timestep, start first; the agent rests on the last one.
using VertexPath = Vertices;

/// The path of each agent up to its last arrival.
std::vector<VertexPath> pathsOf(const std::vector<Vertices>& plan);

/// The plan of paths: as many configurations as the longest path.
std::vector<Vertices> planOf(const std::vector<VertexPath>& paths);

/// Sum of the arrival timesteps.
long sumOfCosts(const std::vector<VertexPath>& paths);

}  // namespace sylph
