#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph_mocap_bridge {

/// Where a frame is in another: `position_m` and `orientation` (unit) take its points there.
struct Pose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// a_from_c = a_from_b * b_from_c
inline Pose operator*(const Pose& a_from_b, const Pose& b_from_c) {
  return {a_from_b.position_m + a_from_b.orientation * b_from_c.position_m,
          (a_from_b.orientation * b_from_c.orientation).normalized()};
}

/// On the floor, upright.
inline Pose toPose(const sylph::Pose2d& planar) {
  return {{planar.x_m, planar.y_m, 0.0},
          Eigen::Quaterniond(Eigen::AngleAxisd(planar.yaw_rad, Eigen::Vector3d::UnitZ()))};
}

/// Heading in (-pi, pi] [rad].
inline double yawOf(const Pose& pose) {
  const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

}  // namespace sylph_mocap_bridge
