#include "sylph_mocap_bridge/frame_transform.hpp"

namespace sylph_mocap_bridge {
namespace {

constexpr double kLeastNorm = 0.9;
constexpr double kLargestNorm = 1.1;

/// The same vector in Z-up axes.
Eigen::Vector3d zUp(const Eigen::Vector3d& y_up) {
  return {y_up.x(), -y_up.z(), y_up.y()};
}

}  // namespace

FrameTransform::FrameTransform(UpAxis up_axis, const sylph::Pose2d& map_from_mocap)
    : up_axis_(up_axis), map_from_mocap_(toPose(map_from_mocap)) {}

std::optional<Pose> FrameTransform::mapFromRobot(const Eigen::Vector3d& position_m,
                                                 const Eigen::Vector4d& orientation_xyzw,
                                                 const sylph::Pose2d& body_from_robot) const {
  const double norm = orientation_xyzw.norm();
  // Written so that a norm that is no number fails.
  const bool is_rotation = norm >= kLeastNorm && norm <= kLargestNorm;
  if (!is_rotation || !position_m.allFinite()) {
    return std::nullopt;
  }
  Pose mocap_from_body{position_m, Eigen::Quaterniond(orientation_xyzw / norm)};
  if (up_axis_ == UpAxis::Y) {
    mocap_from_body.position_m = zUp(position_m);
    mocap_from_body.orientation.vec() = zUp(Eigen::Vector3d(mocap_from_body.orientation.vec()));
  }
  return map_from_mocap_ * mocap_from_body * toPose(body_from_robot);
}

}  // namespace sylph_mocap_bridge
