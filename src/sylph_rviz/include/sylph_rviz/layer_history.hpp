#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "sylph_rviz/shapes.hpp"

namespace sylph_rviz {

/// Turns the markers of a layer into the message that makes RViz show these and no others.
class LayerHistory {
 public:
  /// The first message begins with DELETEALL: whatever a former node left goes. Later ones delete
  /// by id what is no longer there, because DELETEALL each time would flicker.
  /// @param lifetime_s  after this time without another message the markers vanish, 0: never [s]
  visualization_msgs::MarkerArray update(Markers markers, double lifetime_s);

 private:
  bool is_first_ = true;
  std::set<std::pair<std::string, int>> shown_;
};

}  // namespace sylph_rviz
