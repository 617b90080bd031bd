#pragma once

#include <optional>

#include "sylph_mocap_bridge/pose.hpp"

namespace sylph_mocap_bridge {

/// Which of the camera system's axes points up: Motive's "Up Axis". Y-up is its default.
enum class UpAxis { Y, Z };

/// From the cameras' axes to the suite's `map`: the only place that knows of the cameras' axes.
///
///     map_from_robot = map_from_mocap * turn(mocap_from_body) * body_from_robot
///
/// where turn() maps Y-up (x, y, z) to Z-up (x, -z, y) and leaves Z-up alone, `map_from_mocap` says
/// where the cameras' origin lies on the map, and `body_from_robot` where the robot's centre and
/// heading lie in its rigid body.
class FrameTransform {
 public:
  /// @param map_from_mocap  where the cameras' origin lies on the map.
  FrameTransform(UpAxis up_axis, const sylph::Pose2d& map_from_mocap);

  /// @param position_m        in the cameras' axes
  /// @param orientation_xyzw  in the cameras' axes, of a length within 0.9 ... 1.1
  /// @return nothing if a number is not finite or the orientation is no rotation
  std::optional<Pose> mapFromRobot(const Eigen::Vector3d& position_m,
                                   const Eigen::Vector4d& orientation_xyzw,
                                   const sylph::Pose2d& body_from_robot) const;

 private:
  UpAxis up_axis_;
  Pose map_from_mocap_;
};

}  // namespace sylph_mocap_bridge
