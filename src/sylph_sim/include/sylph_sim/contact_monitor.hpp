#pragma once

#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "sylph_core/geometry/footprint.hpp"

namespace sylph_sim {

/// Measures, on true footprints, how close robots come and how often they touch.
class ContactMonitor {
 public:
  /// @param footprints  of all robots now; the same robots in the same order in every call
  void update(const std::vector<sylph::Footprint>& footprints);

  /// Smallest gap between two footprints so far [m]; infinite with fewer than two robots.
  double minSeparation() const { return min_separation_m_; }
  /// How often two footprints that were apart began to touch or overlap.
  std::uint32_t collisions() const { return collisions_; }
  /// Pairs of robots, smaller index first, that touch or overlap now.
  const std::set<std::pair<std::size_t, std::size_t>>& contacts() const { return contacts_; }

 private:
  double min_separation_m_ = std::numeric_limits<double>::infinity();
  std::uint32_t collisions_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> contacts_;
};

}  // namespace sylph_sim
