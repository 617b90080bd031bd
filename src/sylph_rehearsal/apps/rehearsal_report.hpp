#pragma once

#include <string>
#include <vector>

#include "sylph_core/experiment/experiment.hpp"
#include "sylph_rehearsal/rehearsal.hpp"

namespace sylph_rehearsal {

/// How the runs of an experiment went, as text: how they ended, a distribution of each figure, and
/// who waited for whom.
std::string toTable(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs);

/// The same as one line of JSON, with every run.
std::string toJson(const sylph::Experiment& experiment, const std::vector<Rehearsal>& runs);

}  // namespace sylph_rehearsal
