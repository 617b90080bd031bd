#include "bridge.hpp"

#include <cmath>

namespace sylph_rehearsal {

void Bridge::start() {
  sylph_mocap_bridge::TracksOptions options;
  options.body_from_robot.resize(robots_);
  tracks_.emplace(options);
}

void Bridge::onFrame(const sylph_sim::CapturedFrame& frame, double now_s) {
  if (!tracks_) {
    return;
  }
  for (std::size_t robot = 0; robot < frame.bodies.size(); ++robot) {
    const sylph_sim::CapturedBody& body = frame.bodies[robot];
    sylph_mocap_bridge::Measurement measurement;
    measurement.robot = robot;
    measurement.tracked = body.is_tracked;
    measurement.position_m = {body.pose.x_m, body.pose.y_m, 0.0};
    measurement.orientation_xyzw = {0.0, 0.0, std::sin(body.pose.yaw_rad / 2.0),
                                    std::cos(body.pose.yaw_rad / 2.0)};
    measurement.time_s = frame.captured_s;
    measurement.stamp_s = frame.captured_s;
    if (const auto state = tracks_->update(measurement, now_s)) {
      const sylph_mocap_bridge::Pose& pose = state->map_from_robot;
      pose_(robot, {pose.position_m.x(), pose.position_m.y(), yawOf(pose)}, state->stamp_s);
    }
  }
}

}  // namespace sylph_rehearsal
