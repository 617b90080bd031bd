#pragma once

#include "sylph_core/control/safety_margin.hpp"
#include "sylph_core/experiment/experiment.hpp"

namespace sylph {

/// Of the largest footprint in an experiment.
SafetyFactors safetyFactors(const Experiment& experiment);

/// @throws std::runtime_error unless the verdict is Run, naming the file and what to change
SafetyMargin requireSafetyMargin(const Experiment& experiment);

}  // namespace sylph
