#pragma once

#include "sylph_core/mapf/instance.hpp"
#include "sylph_core/mapf/types.hpp"

namespace sylph {

/// Quality of a plan in the field's measures. An agent arrives at the first timestep from which on
/// it rests on its goal.
struct PlanMetrics {
  int steps = 0;          ///< number of joint actions, plan.size() - 1
  int makespan = 0;       ///< last arrival; of agents that never arrive, `steps`
  long sum_of_costs = 0;  ///< sum of arrival timesteps; of agents that never arrive, `steps`
  int arrived = 0;        ///< agents that rest on their goal at the end
};

/// @throws std::invalid_argument if the plan is empty or its width is not the instance's
PlanMetrics computeMetrics(const Instance& instance, const Plan& plan);

/// Sum over the agents of the shortest path length from start to goal [cells].
/// @throws std::invalid_argument if a goal cannot be reached
long sumOfCostsLowerBound(const Instance& instance);

}  // namespace sylph
