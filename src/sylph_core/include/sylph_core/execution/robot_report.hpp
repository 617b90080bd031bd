#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sylph_core/execution/states.hpp"
#include "sylph_core/geometry/pose2d.hpp"

namespace sylph {

/// What a robot tells of itself: its whole state, so that a lost or doubled report does no harm.
struct RobotReport {
  std::uint32_t report_id = 0;  ///< counts up
  double stamp_s = 0.0;         ///< when measured, by the robot's clock [s]
  std::uint32_t plan_id = 0;    ///< plan of the counts below; 0: none yet
  int accepted = 0;             ///< tasks of the plan received without a gap
  int done = 0;                 ///< tasks of the plan done by measured arrival
  RobotState state = RobotState::Holding;
  std::string detail;              ///< why it holds or is blind, for the operator
  std::optional<Pose2d> pose;      ///< the last good one; nothing before the first
  double tracking_error_m = 0.0;   ///< distance from the planned segment
  double heading_error_rad = 0.0;  ///< from the held heading
  double pose_age_s = 0.0;         ///< of the last good pose; infinite before the first
};

/// Whether two reports tell the same of state and tasks, which is what others wait for.
bool tellTheSame(const RobotReport& a, const RobotReport& b);

}  // namespace sylph
