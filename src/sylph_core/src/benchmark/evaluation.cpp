#include "sylph_core/benchmark/evaluation.hpp"

namespace sylph {

Evaluation evaluate(const Instance& instance, const PlanningResult& result) {
  Evaluation evaluation;
  // A planner's own word is not enough.
  if (result.outcome == Outcome::Solved) {
    evaluation.violation = checkPlan(instance, result.plan);
    evaluation.is_solved = !evaluation.violation.has_value();
  }
  const Plan nothing_done = {instance.starts};
  const bool can_be_measured =
      !result.plan.empty() &&
      !(evaluation.violation && evaluation.violation->kind == ViolationKind::WrongAgentCount);
  evaluation.metrics = computeMetrics(instance, can_be_measured ? result.plan : nothing_done);
  evaluation.sum_of_costs_lower_bound = result.statistics.sum_of_costs_lower_bound;
  return evaluation;
}

}  // namespace sylph
