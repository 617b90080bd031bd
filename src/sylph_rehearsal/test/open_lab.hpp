#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rehearsal/lab_fault.hpp"
#include "sylph_sim/fault.hpp"

namespace sylph_rehearsal {

constexpr double kForGood = std::numeric_limits<double>::infinity();

/// An experiment on a floor without obstacles, planned without a policy.
/// @param missions  start and goal of robot_0, robot_1, ...
inline sylph::Experiment openLab(int rows, int cols,
                                 const std::vector<std::pair<sylph::Cell, sylph::Cell>>& missions,
                                 std::uint32_t seed = 1) {
  sylph::Experiment experiment;
  experiment.name = "open_lab";
  experiment.grid = sylph::Grid(rows, cols);
  experiment.seed = seed;
  for (const auto& [start, goal] : missions) {
    sylph::RobotSpec robot;
    robot.name = "robot_" + std::to_string(experiment.robots.size());
    robot.rigid_body = robot.name;
    robot.start = start;
    robot.goal = goal;
    experiment.robots.push_back(robot);
  }
  return experiment;
}

inline LabFault faultOf(LabFaultKind kind, std::vector<std::size_t> robots, double at_s,
                        double duration_s, double value = 0.0) {
  LabFault fault;
  fault.kind = kind;
  fault.fault.robots = std::move(robots);
  fault.fault.at_s = at_s;
  fault.fault.duration_s = duration_s;
  fault.fault.value = value;
  return fault;
}

inline LabFault simulated(sylph_sim::FaultKind kind, std::vector<std::size_t> robots, double at_s,
                          double duration_s, double value) {
  LabFault fault = faultOf(LabFaultKind::Simulated, std::move(robots), at_s, duration_s, value);
  fault.fault.kind = kind;
  return fault;
}

inline LabFault simulated(sylph_sim::FaultKind kind, std::vector<std::size_t> robots, double at_s,
                          double duration_s) {
  return simulated(kind, std::move(robots), at_s, duration_s, sylph_sim::defaultValue(kind));
}

}  // namespace sylph_rehearsal
