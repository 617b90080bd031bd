#include "sylph_core/mapf/metrics.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sylph_core/grid/distance_field.hpp"

namespace sylph {

PlanMetrics computeMetrics(const Instance& instance, const Plan& plan) {
  const bool is_as_wide = std::all_of(plan.begin(), plan.end(), [&](const Configuration& cells) {
    return cells.size() == instance.goals.size();
  });
  if (plan.empty() || !is_as_wide) {
    throw std::invalid_argument("the plan is empty or its width is not the instance's " +
                                std::to_string(instance.goals.size()) + " agents");
  }
  PlanMetrics metrics;
  metrics.steps = static_cast<int>(plan.size()) - 1;
  for (std::size_t agent = 0; agent < instance.goals.size(); ++agent) {
    const Cell& goal = instance.goals[agent];
    // Whoever does not arrive costs the whole plan.
    int cost = metrics.steps;
    if (plan.back()[agent] == goal) {
      ++metrics.arrived;
      while (cost > 0 && plan[static_cast<std::size_t>(cost - 1)][agent] == goal) {
        --cost;
      }
    }
    metrics.makespan = std::max(metrics.makespan, cost);
    metrics.sum_of_costs += cost;
  }
  return metrics;
}

long sumOfCostsLowerBound(const Instance& instance) {
  long sum = 0;
  for (std::size_t agent = 0; agent < instance.goals.size(); ++agent) {
    const int distance =
        DistanceField(instance.grid, instance.goals[agent]).at(instance.starts[agent]);
    if (distance == DistanceField::kUnreachable) {
      throw std::invalid_argument("goal " + toString(instance.goals[agent]) + " of agent " +
                                  std::to_string(agent) + " cannot be reached from its start " +
                                  toString(instance.starts[agent]));
    }
    sum += distance;
  }
  return sum;
}

}  // namespace sylph
