#include "sylph_core/planners/stepwise_planner.hpp"

#include <utility>

#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/pibt_steps.hpp"

namespace sylph {

StepwisePlanner::StepwisePlanner(std::string name, GuideFactory make_guide)
    : name_(std::move(name)), make_guide_(std::move(make_guide)) {}

PlanningResult StepwisePlanner::plan(const Instance& instance, const PlanningLimits& limits,
                                     Rng& rng) const {
  const Deadline deadline(limits.time_limit_s);
  const SearchProblem problem(instance);
  const auto guide = make_guide_(problem, instance, limits.threads, rng);
  const auto generator = guide->makeGenerator();
  std::vector<Vertices> configurations = {problem.starts};
  Priorities priorities(problem.starts.size(), 0);
  PlanningResult result;
  result.outcome = Outcome::Solved;
  while (configurations.back() != problem.goals) {
    if (static_cast<int>(configurations.size()) > limits.max_steps) {
      result.outcome = Outcome::StepLimit;
      break;
    }
    if (deadline.isOver()) {
      result.outcome = Outcome::TimeLimit;
      break;
    }
    const Vertices& now = configurations.back();
    const Vertices* before =
        configurations.size() > 1 ? &configurations[configurations.size() - 2] : nullptr;
    priorities = updatePriorities(priorities, now, problem.goals);
    Vertices next(problem.starts.size(), kNoVertex);
    generator->enter(now, before, priorities)->generate(next);
    configurations.push_back(std::move(next));
  }
  result.plan = problem.graph.toPlan(configurations);
  result.social = guide->socialStates(configurations);
  result.statistics.search_nodes = static_cast<long>(configurations.size());
  result.statistics.policy_calls = guide->policyCalls();
  result.statistics.total_s = deadline.elapsed();
  result.statistics.first_solution_s = result.statistics.total_s;
  return result;
}

}  // namespace sylph
