#pragma once

#include <functional>
#include <optional>

#include "sylph_core/geometry/pose2d.hpp"
#include "sylph_mocap_bridge/robot_tracks.hpp"
#include "sylph_sim/cameras.hpp"

namespace sylph_rehearsal {

/// The motion-capture bridge: frames in, poses to rely on out.
class Bridge {
 public:
  /// A pose of a robot and its stamp [s].
  using PosePort = std::function<void(std::size_t, const sylph::Pose2d&, double)>;

  Bridge(std::size_t robots, PosePort pose) : robots_(robots), pose_(std::move(pose)) {}

  void start();
  void crash() { tracks_.reset(); }
  bool isUp() const { return tracks_.has_value(); }

  /// @param now_s  when the frame comes
  void onFrame(const sylph_sim::CapturedFrame& frame, double now_s);

 private:
  std::size_t robots_;
  PosePort pose_;
  std::optional<sylph_mocap_bridge::RobotTracks> tracks_;
};

}  // namespace sylph_rehearsal
