#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sylph_core/execution/states.hpp"
#include "sylph_core/geometry/vector2.hpp"

namespace sylph {

/// What a robot tells of itself: its whole state, so that a lost or doubled report does no harm.
struct RobotReport {
  std::uint32_t report_id = 0;  ///< counts up
  double stamp_s = 0.0;         ///< when measured, by the robot's clock [s]
  std::uint32_t plan_id = 0;    ///< plan of the counts below; 0: none yet
  int accepted = 0;             ///< tasks of the plan received without a gap
  int done = 0;                 ///< tasks of the plan done by measured arrival
  ReportState state = ReportState::Idle;
  std::string detail;             ///< why it holds or is blind
  std::optional<Point> position;  ///< measured [m]; nothing if it is not a number
  double tracking_error_m = 0.0;
  double pose_age_s = 0.0;
};

}  // namespace sylph
