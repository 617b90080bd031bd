#include "sylph_core/files/nearest_names.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace sylph {
namespace {

/// Letters and digits, small: what is left of names that differ in nothing else.
std::string skeletonOf(const std::string& name) {
  std::string skeleton;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      skeleton.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
  }
  return skeleton;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> distance(b.size() + 1);
  std::iota(distance.begin(), distance.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = distance[0];
    distance[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = distance[j + 1];
      distance[j + 1] = std::min({replaced, distance[j] + 1, distance[j + 1] + 1});
    }
  }
  return distance.back();
}

}  // namespace

std::vector<std::string> nearestNames(const std::string& name,
                                      const std::vector<std::string>& existing, std::size_t most) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  ranked.reserve(existing.size());
  for (const std::string& candidate : existing) {
    ranked.emplace_back(editDistance(skeletonOf(name), skeletonOf(candidate)), candidate);
  }
  std::sort(ranked.begin(), ranked.end());
  ranked.resize(std::min(most, ranked.size()));
  std::vector<std::string> names;
  names.reserve(ranked.size());
  for (const auto& [distance, candidate] : ranked) {
    names.push_back(candidate);
  }
  return names;
}

}  // namespace sylph
