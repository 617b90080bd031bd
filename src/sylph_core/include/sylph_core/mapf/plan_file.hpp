#pragma once

#include <string>

#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Reads a plan, one configuration a line: "step: (row,col) (row,col) ...", steps from 0 on, the
/// same number of agents in each. Whether it solves anything is for checkPlan() to say.
/// @throws std::runtime_error with one line: file, line, what is wrong, what is allowed
Plan loadPlan(const std::string& path);

/// Writes what loadPlan() reads.
/// @throws std::runtime_error naming the file if it cannot be written
void savePlan(const Plan& plan, const std::string& path);

}  // namespace sylph
