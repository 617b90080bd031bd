#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <limits>
#include <string>

#include "sylph_core/geometry/pose2d.hpp"

namespace sylph_ros {

/// Why a pose must not be used.
enum class PoseFault {
  None,
  Old,         ///< it came longer ago than allowed
  Frame,       ///< not in frame `map`
  NotFinite,   ///< a number is none
  NoRotation,  ///< its quaternion is not of unit length (0.9 ... 1.1), such as all zeros
};

/// A measured pose and whether it may be used.
struct JudgedPose {
  PoseFault fault = PoseFault::None;  ///< the first one found
  std::string reason;  ///< what is wrong, to follow "the pose of robot_3 "; empty if nothing is
  sylph::Pose2d pose;  ///< in frame `map`; its numbers are NaN if there is a fault
};

/// The one judgement of a measured pose: everybody who uses poses asks here.
/// @param age_s      since it came [s]
/// @param max_age_s  an older one is not used [s]
JudgedPose judgePose(const geometry_msgs::PoseStamped& message, double age_s = 0.0,
                     double max_age_s = std::numeric_limits<double>::infinity());

}  // namespace sylph_ros
