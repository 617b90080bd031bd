#pragma once

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/grid/cell_frame.hpp"
#include "sylph_core/mission/mission.hpp"
#include "sylph_core/mission/start_cells.hpp"

/// The lab of data/small_lab.yaml, and what a test says about it.
namespace sylph {

inline Experiment smallLab() {
  return loadExperiment(std::string(SYLPH_TEST_DATA) + "/small_lab.yaml");
}

/// The mission of the small lab: robots 0, 1, 2 to their goals.
inline Mission smallMission() {
  return toMission(smallLab());
}

inline Configuration smallStarts() {
  return toInstance(smallLab()).starts;
}

/// A pose in the middle of a cell.
inline Pose2d pose2dIn(const Mission& mission, const Cell& cell) {
  const Point point = CellFrame(mission.grid, mission.cell_size_m).toPoint(cell);
  return {point.x, point.y, 0.0};
}

/// All robots of the small lab in the middle of their starts.
inline RobotPoses posesInStarts() {
  const Mission mission = smallMission();
  RobotPoses poses;
  for (std::size_t i = 0; i < mission.robots.size(); ++i) {
    poses[mission.robots[i]] = {pose2dIn(mission, smallStarts()[i]), {}};
  }
  return poses;
}

/// The message of the failure that `call` throws, with its outcome in front: "1: unknown robot".
template <typename Call>
std::string failureOf(const Call& call) {
  try {
    call();
  } catch (const MissionFailure& failure) {
    return std::to_string(static_cast<int>(failure.outcome())) + ": " + failure.what();
  }
  return "no failure";
}

}  // namespace sylph
