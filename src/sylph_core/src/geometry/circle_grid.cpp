#include "sylph_core/geometry/circle_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sylph {
namespace {

/// The last layer's circles meet everything.
constexpr std::size_t kMostLayers = 64;
/// Farther out all cells are one [cells].
constexpr double kFarthest = 1e9;
/// Keeps rounding from leaving out circles that just touch.
constexpr double kRounding = 1.0 + 1e-9;
/// Bits of a key that are the row.
constexpr int kHalf = 32;

}  // namespace

CircleGrid::CircleGrid(double usual_radius_m)
    : layers_{{usual_radius_m, 2.0 * usual_radius_m, {}}} {}

std::size_t CircleGrid::layerFor(double radius_m) {
  std::size_t layer = 0;
  while (layers_[layer].radius_m < radius_m) {
    ++layer;
    if (layer == layers_.size()) {
      const bool is_last = layer + 1 == kMostLayers;
      const double largest_m =
          is_last ? std::numeric_limits<double>::infinity() : 2.0 * layers_.back().radius_m;
      layers_.push_back({largest_m, 2.0 * layers_.back().side_m, {}});
    }
  }
  return layer;
}

CircleGrid::CellPosition CircleGrid::cellAt(const Point& point, double side_m) {
  const auto along = [side_m](double coordinate_m) {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(coordinate_m / side_m), -kFarthest, kFarthest));
  };
  return {along(point.x), along(point.y)};
}

CircleGrid::Key CircleGrid::keyOf(const CellPosition& cell) {
  return static_cast<Key>(static_cast<std::uint32_t>(cell.col)) << kHalf |
         static_cast<std::uint32_t>(cell.row);
}

CircleGrid::CellPosition CircleGrid::cellOf(Key key) {
  return {static_cast<std::int32_t>(key >> kHalf), static_cast<std::int32_t>(key)};
}

void CircleGrid::put(int index, const Point& center, double radius_m) {
  const auto slot = static_cast<std::size_t>(index);
  if (slot >= places_.size()) {
    places_.resize(slot + 1);
  }
  const std::size_t layer = layerFor(radius_m);
  const Key cell = keyOf(cellAt(center, layers_[layer].side_m));
  Place& place = places_[slot];
  if (place.is_set && place.layer == layer && place.cell == cell) {
    return;
  }
  if (place.is_set) {
    take(index, place);
  }
  place = {layer, cell, true};
  layers_[layer].cells[cell].push_back(index);
}

void CircleGrid::take(int index, const Place& place) {
  auto& cells = layers_[place.layer].cells;
  const auto left = cells.find(place.cell);
  std::vector<int>& members = left->second;
  members.erase(std::find(members.begin(), members.end(), index));
  if (members.empty()) {
    cells.erase(left);
  }
}

std::vector<int> CircleGrid::near(const Point& center, double radius_m) const {
  std::vector<int> found;
  for (const Layer& layer : layers_) {
    if (!layer.cells.empty()) {
      addNear(layer, center, (radius_m + layer.radius_m) * kRounding, found);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

void CircleGrid::addNear(const Layer& layer, const Point& center, double reach_m,
                         std::vector<int>& found) {
  const CellPosition low = cellAt({center.x - reach_m, center.y - reach_m}, layer.side_m);
  const CellPosition high = cellAt({center.x + reach_m, center.y + reach_m}, layer.side_m);
  const auto add = [&found](const std::vector<int>& members) {
    found.insert(found.end(), members.begin(), members.end());
  };
  // Whichever is less: the cells within reach, or those that are not empty.
  const double cells_within = (1.0 + high.col - low.col) * (1.0 + high.row - low.row);
  if (cells_within > static_cast<double>(layer.cells.size())) {
    for (const auto& [key, members] : layer.cells) {
      const CellPosition at = cellOf(key);
      if (low.col <= at.col && at.col <= high.col && low.row <= at.row && at.row <= high.row) {
        add(members);
      }
    }
    return;
  }
  for (std::int32_t col = low.col; col <= high.col; ++col) {
    for (std::int32_t row = low.row; row <= high.row; ++row) {
      const auto cell = layer.cells.find(keyOf({col, row}));
      if (cell != layer.cells.end()) {
        add(cell->second);
      }
    }
  }
}

}  // namespace sylph
