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

visualization_msgs::MarkerArray LayerHistory::update(Markers markers, double lifetime_s,
                                                     double now_s) {
  visualization_msgs::MarkerArray message;
  if (is_first_) {
    message.markers.push_back(makeDeletion("", 0, Marker::DELETEALL));
    is_first_ = false;
  }
  std::map<std::pair<std::string, int>, Sent> sent;
  for (Marker& marker : markers) {
    marker.lifetime = ros::Duration(lifetime_s);
    const std::pair<std::string, int> key(marker.ns, marker.id);
    const auto before = sent_.find(key);
    if (!sends_all_ && before != sent_.end() && now_s - before->second.at_s < refresh_s_ &&
        before->second.marker == marker) {
      sent.insert(sent_.extract(before));
      continue;
    }
    message.markers.push_back(marker);
    sent[key] = {std::move(marker), now_s};
    sent_.erase(key);
  }
  for (const auto& [key, gone] : sent_) {
    message.markers.push_back(makeDeletion(key.first, key.second, Marker::DELETE));
  }
  sent_ = std::move(sent);
  sends_all_ = false;
  return message;
}

}  // namespace sylph_rviz
