#include "sylph_core/planners/stepwise_planner.hpp"

#include <utility>

#include "sylph_core/search/pibt_steps.hpp"

namespace sylph {

SearchResult StepwisePlanner::search(const SearchProblem& problem, Guide& guide,
                                     const PlanningLimits& limits, const Deadline& deadline,
                                     Rng& /*rng*/, PlanningStatistics& statistics) const {
  const auto generator = guide.makeGenerator();
  SearchResult result{Outcome::Solved, {problem.starts}};
  std::vector<Vertices>& plan = result.plan;
  Priorities priorities(problem.starts.size(), 0);
  while (plan.back() != problem.goals) {
    if (static_cast<int>(plan.size()) > limits.max_steps) {
      result.outcome = Outcome::StepLimit;
      break;
    }
    if (deadline.isOver()) {
      result.outcome = Outcome::TimeLimit;
      break;
    }
    const Vertices* before = plan.size() > 1 ? &plan[plan.size() - 2] : nullptr;
    priorities = updatePriorities(priorities, plan.back(), problem.goals);
    Vertices next(problem.starts.size(), kNoVertex);
    generator->enter(plan.back(), before, priorities)->generate(next);
    plan.push_back(std::move(next));
  }
  statistics.search_nodes = static_cast<long>(plan.size());
  statistics.first_solution_s = deadline.elapsed();
  return result;
}

}  // namespace sylph
