#pragma once

#include <optional>

#include "sylph_core/mapf/check_plan.hpp"
#include "sylph_core/mapf/metrics.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// What a planner's answer is worth.
struct Evaluation {
  bool is_solved = false;                        ///< the planner says so, and checkPlan() agrees
  PlanMetrics metrics;                           ///< of the plan as far as it came
  std::optional<long> sum_of_costs_lower_bound;  ///< as far as the planner came to know it
  std::optional<PlanViolation> violation;  ///< in a plan that the planner takes for a solution
};

/// Judges an answer. A plan that the planner takes for no solution is only measured; one of another
/// number of agents, as if nobody had moved.
Evaluation evaluate(const Instance& instance, const PlanningResult& result);

}  // namespace sylph
