#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>
#include <utility>

#include "sylph_rviz/shapes.hpp"

namespace sylph_rviz {

/// Turns the markers of a layer into messages that make RViz show these and no others. RViz builds
/// each marker anew that it is sent: with fifty robots that takes longer than to draw them all.
class LayerHistory {
 public:
  /// @param refresh_s  a marker that has not changed is sent again after this time [s]
  explicit LayerHistory(double refresh_s = 0.0) : refresh_s_(refresh_s) {}

  /// What has changed since the last message, and what has to be sent again. The first message
  /// begins with DELETEALL: whatever a former node left goes. Later ones delete by id what is no
  /// longer there, because DELETEALL each time would flicker.
  /// @param lifetime_s  after this time without another message the markers vanish, 0: never [s]
  /// @param now_s       steady time [s]
  visualization_msgs::MarkerArray update(Markers markers, double lifetime_s, double now_s);

  /// The next message has all markers: a subscriber is new, or has forgotten them.
  void sendAll() { sends_all_ = true; }

 private:
  struct Sent {
    Marker marker;
    double at_s = 0.0;
  };

  double refresh_s_;
  bool is_first_ = true;
  bool sends_all_ = false;
  std::map<std::pair<std::string, int>, Sent> sent_;
};

}  // namespace sylph_rviz
