#pragma once

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

namespace sylph_rehearsal {

/// How the runs of an experiment went, as one HTML page that needs no other file: how they ended
/// and why, distributions of times and distances, faults, waits.
/// @param runs  at least one
std::string toPage(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs);

}  // namespace sylph_rehearsal
