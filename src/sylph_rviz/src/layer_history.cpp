#include "sylph_rviz/layer_history.hpp"

#include "sylph_ros/topics.hpp"

namespace sylph_rviz {
namespace {

Marker makeDeletion(const std::string& ns, int id, int action) {
  Marker marker;
  marker.header.frame_id = sylph_ros::kMapFrame;
  marker.ns = ns;
  marker.id = id;
  marker.action = action;
  marker.pose.orientation.w = 1.0;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray LayerHistory::update(Markers markers, double lifetime_s) {
  visualization_msgs::MarkerArray message;
  if (is_first_) {
    message.markers.push_back(makeDeletion("", 0, Marker::DELETEALL));
    is_first_ = false;
  }
  std::set<std::pair<std::string, int>> shown;
  for (Marker& marker : markers) {
    shown.emplace(marker.ns, marker.id);
    marker.lifetime = ros::Duration(lifetime_s);
    message.markers.push_back(std::move(marker));
  }
  for (const auto& [ns, id] : shown_) {
    if (shown.count({ns, id}) == 0) {
      message.markers.push_back(makeDeletion(ns, id, Marker::DELETE));
    }
  }
  shown_ = std::move(shown);
  return message;
}

}  // namespace sylph_rviz
