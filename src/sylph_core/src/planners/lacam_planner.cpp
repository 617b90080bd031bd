#include "sylph_core/planners/lacam_planner.hpp"

#include <utility>

#include "sylph_core/planners/first_solution.hpp"
#include "sylph_core/planners/improvement.hpp"
#include "sylph_core/planners/social_states.hpp"
#include "sylph_core/search/lacam.hpp"

namespace sylph {
namespace {

Outcome outcomeOf(Lacam::Status status, std::size_t plan_size, const PlanningLimits& limits) {
  switch (status) {
    case Lacam::Status::Exhausted:
      return Outcome::Unsolvable;
    case Lacam::Status::Unfinished:
      return Outcome::TimeLimit;
    case Lacam::Status::Solved:
      break;
  }
  return static_cast<int>(plan_size) - 1 > limits.max_steps ? Outcome::StepLimit : Outcome::Solved;
}

}  // namespace

LacamPlanner::LacamPlanner(std::string name, GeneratorFactory make_generator)
    : name_(std::move(name)), make_generator_(std::move(make_generator)) {}

PlanningResult LacamPlanner::plan(const Instance& instance, const PlanningLimits& limits,
                                  Rng& rng) const {
  const Deadline deadline(limits.time_limit_s);
  const SearchProblem problem(instance);
  FirstSolution first = findFirstSolution(problem, make_generator_, deadline, rng);
  PlanningResult result;
  result.statistics.first_solution_s = deadline.elapsed();
  result.statistics.search_nodes = first.nodes;
  std::vector<Vertices> best = std::move(first.plan);
  if (first.status == Lacam::Status::Solved && !limits.first_solution_only) {
    Improvement improvement =
        improve(problem, std::move(best), make_generator_, limits.threads, deadline, rng);
    best = std::move(improvement.plan);
    result.statistics.improvements = improvement.improvements;
    result.statistics.search_nodes += improvement.nodes;
  }
  result.plan = problem.graph.toPlan(best);
  result.outcome = outcomeOf(first.status, result.plan.size(), limits);
  result.social = socialStatesOf(problem, instance.grid, result.plan);
  result.statistics.total_s = deadline.elapsed();
  return result;
}

}  // namespace sylph
