#include "sylph_sim/contact_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph_sim {
namespace {

double radius(const sylph::Footprint& footprint) {
  return std::hypot(footprint.length_m, footprint.width_m) / 2.0;
}

}  // namespace

void ContactMonitor::update(const std::vector<sylph::Footprint>& footprints) {
  if (footprints.empty()) {
    return;
  }
  std::vector<std::size_t> by_x(footprints.size());
  std::iota(by_x.begin(), by_x.end(), 0);
  std::sort(by_x.begin(), by_x.end(), [&footprints](std::size_t a, std::size_t b) {
    return std::pair(footprints[a].center.x, a) < std::pair(footprints[b].center.x, b);
  });
  std::vector<double> radius_m;
  radius_m.reserve(footprints.size());
  for (const sylph::Footprint& footprint : footprints) {
    radius_m.push_back(radius(footprint));
  }
  const double largest_radius_m = *std::max_element(radius_m.begin(), radius_m.end());
  std::set<std::pair<std::size_t, std::size_t>> contacts;
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const sylph::Footprint& a = footprints[by_x[i]];
    for (std::size_t j = i + 1; j < by_x.size(); ++j) {
      const sylph::Footprint& b = footprints[by_x[j]];
      // Robots that are farther apart than the smallest gap so far change nothing; at first, when
      // that gap is infinite, every pair is measured.
      if (b.center.x - a.center.x > 2.0 * largest_radius_m + min_separation_m_) {
        break;
      }
      const double distance_m = sylph::distance(a.center, b.center);
      if (distance_m > radius_m[by_x[i]] + radius_m[by_x[j]] + min_separation_m_) {
        continue;
      }
      const double gap_m = sylph::footprintGap(a, b);
      min_separation_m_ = std::min(min_separation_m_, gap_m);
      if (gap_m <= 0.0) {
        contacts.insert(std::minmax(by_x[i], by_x[j]));
      }
    }
  }
  for (const auto& pair : contacts) {
    collisions_ += contacts_.count(pair) == 0 ? 1 : 0;
  }
  contacts_ = std::move(contacts);
}

}  // namespace sylph_sim
