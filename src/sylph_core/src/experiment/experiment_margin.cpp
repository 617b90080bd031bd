#include "sylph_core/experiment/experiment_margin.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace sylph {

SafetyFactors safetyFactors(const Experiment& experiment) {
  SafetyFactors factors;
  for (const RobotSpec& robot : experiment.robots) {
    // Of any two robots that meet the larger ones count.
    factors.length_m = std::max(factors.length_m, robot.length_m);
    factors.width_m = std::max(factors.width_m, robot.width_m);
  }
  const ExecutionSpec& execution = experiment.execution;
  factors.cell_size_m = experiment.cell_size_m;
  factors.heading_tolerance_rad = execution.heading_tolerance_rad;
  factors.tracking_error_m = execution.tracking_error_m;
  factors.position_tolerance_m = execution.position_tolerance_m;
  factors.speed_limit_mps = execution.speed_limit_mps;
  factors.acceleration_limit_mps2 = execution.acceleration_limit_mps2;
  factors.pose_timeout_s = execution.pose_timeout_s;
  factors.base_timeout_s = execution.base_timeout_s;
  factors.command_latency_s = execution.command_latency_s;
  return factors;
}

SafetyMargin requireSafetyMargin(const Experiment& experiment) {
  SafetyMargin margin = computeSafetyMargin(safetyFactors(experiment));
  if (margin.verdict == SafetyVerdict::Run) {
    return margin;
  }
  std::string changes;
  for (const std::string& remedy : margin.remedies) {
    changes += (changes.empty() ? "; change " : ", or ") + remedy;
  }
  throw std::runtime_error(experiment.path + ": no safety margin: " + margin.summary() + changes);
}

StartLimits startLimits(const Experiment& experiment) {
  const SafetyFactors factors = safetyFactors(experiment);
  const SafetyMargin margin = requireSafetyMargin(experiment);
  const double half_m = experiment.cell_size_m / 2.0;
  const double intrusion_m = margin.reach_m + std::max(margin.error_m, margin.overrun_m) - half_m;
  return {factors.length_m, factors.width_m, half_m - std::max(0.0, intrusion_m)};
}

AlignmentLimits alignmentLimits(const Experiment& experiment) {
  const SafetyFactors factors = safetyFactors(experiment);
  const ExecutionSpec& execution = experiment.execution;
  // Turning moves a corner faster than driving moves the whole robot.
  const double corner_mps =
      execution.turn_rate_limit_radps * std::hypot(factors.length_m, factors.width_m) / 2.0;
  const double blind_s = requireSafetyMargin(experiment).overrun_m / execution.speed_limit_mps;
  return {footprintsOf(experiment), experiment.grid,
          execution.tracking_error_m + corner_mps * blind_s + separationLimits(experiment).limit_m};
}

void applyExperiment(const Experiment& experiment, bool align, ExecutionLimits& limits) {
  limits.start = startLimits(experiment);
  limits.alignment =
      align ? std::make_shared<const AlignmentLimits>(alignmentLimits(experiment)) : nullptr;
}

double bystanderDistance(const Experiment& lab) {
  return lab.cell_size_m / 2.0 - startLimits(lab).room_m;
}

std::vector<Footprint> footprintsOf(const Experiment& experiment) {
  std::vector<Footprint> footprints;
  for (const RobotSpec& robot : experiment.robots) {
    Footprint footprint;
    footprint.length_m = robot.length_m;
    footprint.width_m = robot.width_m;
    footprints.push_back(footprint);
  }
  return footprints;
}

SeparationLimits separationLimits(const Experiment& experiment) {
  SeparationLimits limits;
  // Robots that keep to their tolerances come as close as the margin says.
  limits.limit_m = requireSafetyMargin(experiment).promisedSeparation() / 2.0;
  limits.command_latency_s = experiment.execution.command_latency_s;
  return limits;
}

}  // namespace sylph
