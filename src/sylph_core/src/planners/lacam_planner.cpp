#include "sylph_core/planners/lacam_planner.hpp"

#include <utility>

#include "sylph_core/planners/social_states.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/large_neighborhood_search.hpp"

namespace sylph {
namespace {

Outcome outcomeOf(const Lacam& lacam, Lacam::Status status, const PlanningResult& result,
                  const PlanningLimits& limits) {
  if (!lacam.isSolved()) {
    return status == Lacam::Status::Exhausted ? Outcome::Unsolvable : Outcome::TimeLimit;
  }
  return static_cast<int>(result.plan.size()) - 1 > limits.max_steps ? Outcome::StepLimit
                                                                     : Outcome::Solved;
}

}  // namespace

LacamPlanner::LacamPlanner(std::string name, GeneratorFactory make_generator)
    : name_(std::move(name)), make_generator_(std::move(make_generator)) {}

PlanningResult LacamPlanner::plan(const Instance& instance, const PlanningLimits& limits,
                                  Rng& rng) const {
  const Deadline deadline(limits.time_limit_s);
  const SearchProblem problem(instance);
  const auto generator = make_generator_(problem, deadline, rng);
  Lacam lacam(problem.graph, problem.starts, problem.goals, problem.distances, problem.motion,
              *generator, rng);
  const Lacam::Status status = lacam.search(deadline);
  PlanningResult result;
  result.statistics.first_solution_s = deadline.elapsed();
  std::vector<Vertices> best = lacam.plan();
  if (lacam.isSolved() && !limits.first_solution_only) {
    LargeNeighborhoodSearch improvement(problem, best);
    improvement.run(deadline, rng);
    best = improvement.plan();
    result.statistics.improvements = improvement.improvementCount();
  }
  result.plan = problem.graph.toPlan(best);
  result.outcome = outcomeOf(lacam, status, result, limits);
  result.social = socialStatesOf(problem, instance.grid, result.plan);
  result.statistics.search_nodes = lacam.nodeCount();
  result.statistics.total_s = deadline.elapsed();
  return result;
}

}  // namespace sylph
