#include "sylph_core/search/paths.hpp"

#include <algorithm>
#include <numeric>

namespace sylph {

std::vector<VertexPath> pathsOf(const std::vector<Vertices>& plan) {
  std::vector<VertexPath> paths(plan.front().size());
  for (std::size_t agent = 0; agent < paths.size(); ++agent) {
    std::size_t length = plan.size();
    // Rest at the end costs nothing and is left out.
    while (length > 1 && plan[length - 2][agent] == plan.back()[agent]) {
      --length;
    }
    for (std::size_t timestep = 0; timestep < length; ++timestep) {
      paths[agent].push_back(plan[timestep][agent]);
    }
  }
  return paths;
}

long sumOfCosts(const std::vector<VertexPath>& paths) {
  return std::accumulate(paths.begin(), paths.end(), 0L, [](long sum, const VertexPath& path) {
    return sum + static_cast<long>(path.size()) - 1;
  });
}

std::vector<Vertices> planOf(const std::vector<VertexPath>& paths) {
  std::size_t length = 1;
  for (const VertexPath& path : paths) {
    length = std::max(length, path.size());
  }
  std::vector<Vertices> plan(length, Vertices(paths.size()));
  for (std::size_t timestep = 0; timestep < length; ++timestep) {
    for (std::size_t agent = 0; agent < paths.size(); ++agent) {
      plan[timestep][agent] = paths[agent][std::min(timestep, paths[agent].size() - 1)];
    }
  }
  return plan;
}

}  // namespace sylph
