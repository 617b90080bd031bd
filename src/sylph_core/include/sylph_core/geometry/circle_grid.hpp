#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// Circles in the plane, by index, in square cells (a cell list): who may meet a circle is found
/// without looking at all of them, so that looking for everybody takes time linear in their number
/// as long as the crowd gets no denser.
///
/// A few large circles do not make the search for the small ones slow: each layer holds those of up
/// to twice the radius of the layer below.
class CircleGrid {
 public:
  /// @param usual_radius_m  of most circles, > 0; it decides about the speed alone
  explicit CircleGrid(double usual_radius_m);

  /// Puts a circle in, or moves one that is in.
  /// @param index     >= 0, and small: there is memory for all indices below
  /// @param center    has to be finite
  /// @param radius_m  >= 0; infinite: it meets every circle
  void put(int index, const Point& center, double radius_m);

  /// Indices, in ascending order, of all circles that touch or overlap this one, and of some others
  /// near it.
  std::vector<int> near(const Point& center, double radius_m) const;

 private:
  using Key = std::uint64_t;
  struct CellPosition {
    std::int32_t col;
    std::int32_t row;
  };
  struct Layer {
    double radius_m;  ///< of its largest circle
    double side_m;    ///< of a cell
    std::unordered_map<Key, std::vector<int>> cells;
  };
  struct Place {
    std::size_t layer = 0;
    Key cell = 0;
    bool is_set = false;
  };

  std::size_t layerFor(double radius_m);
  static CellPosition cellAt(const Point& point, double side_m);
  static Key keyOf(const CellPosition& cell);
  static CellPosition cellOf(Key key);
  void take(int index, const Place& place);
  static void addNear(const Layer& layer, const Point& center, double reach_m,
                      std::vector<int>& found);

  std::vector<Layer> layers_;
  std::vector<Place> places_;  // by index
};

}  // namespace sylph
