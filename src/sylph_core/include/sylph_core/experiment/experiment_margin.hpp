#pragma once

#include <vector>

#include "sylph_core/adg/execution_limits.hpp"
#include "sylph_core/control/safety_margin.hpp"
#include "sylph_core/control/separation.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_core/geometry/footprint.hpp"

namespace sylph {

/// Of the largest footprint in an experiment.
SafetyFactors safetyFactors(const Experiment& experiment);

/// @throws std::runtime_error unless the verdict is Run, naming the file and what to change
SafetyMargin requireSafetyMargin(const Experiment& experiment);

/// How its robots may stand where a plan starts, so that the margin holds for those who pass by.
/// @throws std::runtime_error as requireSafetyMargin()
StartLimits startLimits(const Experiment& experiment);
/// Where robots may be aligned: with a clearance in which one that loses its pose or its node while
/// it turns comes to rest, off its way by the tracking error.
/// @throws std::runtime_error as requireSafetyMargin()
AlignmentLimits alignmentLimits(const Experiment& experiment);
/// Gives the central node's limits what an experiment decides of them: `start`, and `alignment` if
/// robots are to be aligned.
/// @throws std::runtime_error as requireSafetyMargin()
void applyExperiment(const Experiment& experiment, bool align, ExecutionLimits& limits);

/// A robot without part in a mission blocks the cells to which its footprint is so near [m], >= 0:
/// as the central node has it, which would refuse the plan.
/// @throws std::runtime_error as requireSafetyMargin()
double bystanderDistance(const Experiment& lab);

/// Length and width of each robot; where they are is not set.
std::vector<Footprint> footprintsOf(const Experiment& experiment);

/// When its robots are too close.
/// @throws std::runtime_error as requireSafetyMargin()
SeparationLimits separationLimits(const Experiment& experiment);

}  // namespace sylph
