#pragma once

#include <string>

#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// What came of one planner or solver on one case.
enum class RunOutcome {
  Solved,      ///< checkPlan() finds nothing wrong
  TimeLimit,   ///< no plan in the time given; a solver was killed
  StepLimit,   ///< no plan within max_steps
  Unsolvable,  ///< the planner proved that there is no plan
  NoSolution,  ///< the solver ended well without a plan, or says that there is none
  Invalid,     ///< what was given as a plan is none, or solves something else
  Failed,  ///< the solver was killed by a signal, or ended with a status other than 0 and no plan
};

/// As in tables: "solved", "time limit", "step limit", "unsolvable", "no solution", "invalid",
/// "failed".
std::string toString(RunOutcome outcome);

/// Of a planner, by its own word.
RunOutcome toRunOutcome(Outcome outcome);

}  // namespace sylph
