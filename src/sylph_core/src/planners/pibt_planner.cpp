#include "sylph_core/planners/pibt_planner.hpp"

#include <utility>

#include "sylph_core/planners/social_states.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/pibt_generator.hpp"

namespace sylph {

PibtPlanner::PibtPlanner(std::string name, GeneratorFactory make_generator)
    : name_(std::move(name)), make_generator_(std::move(make_generator)) {}

PlanningResult PibtPlanner::plan(const Instance& instance, const PlanningLimits& limits,
                                 Rng& rng) const {
  const Deadline deadline(limits.time_limit_s);
  const SearchProblem problem(instance);
  const auto generator = make_generator_(problem, 0, rng);
  std::vector<Vertices> configurations = {problem.starts};
  std::vector<int> waited(problem.starts.size(), 0);
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
    waited = updateWaited(waited, configurations.back(), problem.goals);
    Vertices next(problem.starts.size(), kNoVertex);
    generator->generate(configurations.back(), generator->order(configurations.back(), waited),
                        next);
    configurations.push_back(std::move(next));
  }
  result.plan = problem.graph.toPlan(configurations);
  result.social = socialStatesOf(problem, instance.grid, result.plan);
  result.statistics.search_nodes = static_cast<long>(configurations.size());
  result.statistics.total_s = deadline.elapsed();
  result.statistics.first_solution_s = result.statistics.total_s;
  return result;
}

}  // namespace sylph
