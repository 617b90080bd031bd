#include "sylph_ros/measured_pose.hpp"

#include <cmath>
#include <cstdio>

#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_ros {
namespace {

JudgedPose refuse(PoseFault fault, const std::string& reason) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {fault, reason, {kNone, kNone, kNone}};
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", value);
  return text;
}

}  // namespace

JudgedPose judgePose(const geometry_msgs::PoseStamped& message, double age_s, double max_age_s) {
  if (!(age_s <= max_age_s)) {
    return refuse(PoseFault::Old, "came " + number(age_s) + " s ago: at most " + number(max_age_s) +
                                      " s are allowed");
  }
  if (message.header.frame_id != kMapFrame) {
    return refuse(PoseFault::Frame,
                  "is in frame '" + message.header.frame_id + "': it must be '" + kMapFrame + "'");
  }
  const geometry_msgs::Quaternion& q = message.pose.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const sylph::Pose2d pose{message.pose.position.x, message.pose.position.y, yawOf(q)};
  if (!sylph::isFinite(pose) || !std::isfinite(norm)) {
    return refuse(PoseFault::NotFinite, "is not a number");
  }
  // All zeros is what a message holds that nobody filled in, and would be read as heading 0.
  if (norm < 0.9 || norm > 1.1) {
    return refuse(PoseFault::NoRotation,
                  "has a quaternion of length " + number(norm) + ": it must be 1");
  }
  return {PoseFault::None, {}, pose};
}

}  // namespace sylph_ros
