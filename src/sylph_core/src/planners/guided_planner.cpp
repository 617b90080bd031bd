#include "sylph_core/planners/guided_planner.hpp"

#include <algorithm>
#include <utility>

namespace sylph {
namespace {

/// Of the time limit. Social states of a few robots take next to no time: they are not left out
/// because a search ended a moment late.
constexpr double kGraceShare = 0.03;

}  // namespace

GuidedPlanner::GuidedPlanner(std::string name, GuideFactory make_guide)
    : name_(std::move(name)), make_guide_(std::move(make_guide)) {}

PlanningResult GuidedPlanner::plan(const Instance& instance, const PlanningLimits& limits,
                                   Rng& rng) const {
  const Deadline deadline(limits.time_limit_s, limits.clock);
  const SearchProblem problem(instance);
  PlanningResult result;
  SearchResult found{Outcome::TimeLimit, {problem.starts}};
  // On large maps this takes longer than all else; nothing can be searched without it.
  if (problem.distances.reach(problem.starts, deadline)) {
    result.statistics.sum_of_costs_lower_bound = problem.distances.sum(problem.starts);
    const auto guide = make_guide_(problem, instance, limits.threads, rng);
    found = search(problem, *guide, limits, deadline, rng, result.statistics);
    const auto longest = static_cast<std::size_t>(limits.max_steps) + 1;
    if (found.plan.size() > longest) {
      found.plan.resize(longest);
      found.outcome = found.outcome == Outcome::Solved ? Outcome::StepLimit : found.outcome;
    }
    if (limits.social_states) {
      result.social = guide->socialStates(
          found.plan, deadline.extended(kGraceShare * std::max(limits.time_limit_s, 0.0)));
    }
    result.statistics.policy_calls = guide->policyCalls();
  }
  result.outcome = found.outcome;
  result.plan = problem.graph.toPlan(found.plan);
  result.statistics.total_s = deadline.elapsed();
  return result;
}

}  // namespace sylph
