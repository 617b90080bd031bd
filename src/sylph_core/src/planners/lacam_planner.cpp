#include "sylph_core/planners/lacam_planner.hpp"

#include <utility>

#include "sylph_core/planners/first_solution.hpp"
#include "sylph_core/planners/improvement.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/paths.hpp"

namespace sylph {
namespace {

constexpr double kShareOfPolicy = 0.5;  // of the time, at most, where there is a solution
constexpr long kStepsOfPolicy = 1000;

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

/// With a policy, the second attempt goes by it, the others by distance.
FirstSolution findBySomeOrder(const SearchProblem& problem, Guide& guide, const Deadline& deadline,
                              Rng& rng) {
  const auto make_generator = [&](const SearchProblem& /*problem*/, int attempt, Rng& /*rng*/) {
    return attempt == 1 ? guide.makeGenerator()
                        : makeDistanceGenerator(problem, attempt > 1 ? attempt - 1 : 0, rng);
  };
  return findFirstSolution(problem, make_generator, deadline, rng);
}

/// By distance a solution mostly is a matter of milliseconds. It is what there is if the network is
/// too slow for the time limit, or leads to something worse.
FirstSolution findSolutionToImprove(const SearchProblem& problem, Guide& guide,
                                    const Deadline& deadline, Rng& rng) {
  if (guide.goesByDistance()) {
    return findFirstSolution(problem, makeDistanceGenerator, deadline, rng);
  }
  FirstSolution first = findBySomeOrder(problem, guide, deadline, rng);
  if (first.status != Lacam::Status::Solved || guide.policyCalls() > 0) {
    return first;
  }
  const auto generator = guide.makeGenerator();
  Lacam lacam(problem, *generator, rng);
  const auto status = lacam.search(Deadline(kShareOfPolicy * deadline.remaining()), kStepsOfPolicy);
  first.nodes += lacam.nodeCount();
  if (status == Lacam::Status::Solved) {
    std::vector<Vertices> plan = lacam.plan();
    if (sumOfCosts(pathsOf(plan)) <= sumOfCosts(pathsOf(first.plan))) {
      first.plan = std::move(plan);
    }
  }
  return first;
}

/// Improvement leaves this time for the network to be asked along the plan [s].
double socialStatesAtMost_s(const Guide& guide, const Deadline& deadline, std::size_t steps) {
  return guide.policyCalls() == 0 ? 0.0
                                  : deadline.elapsed() / static_cast<double>(guide.policyCalls()) *
                                        static_cast<double>(steps);
}

}  // namespace

LacamPlanner::LacamPlanner(std::string name, GuideFactory make_guide)
    : name_(std::move(name)), make_guide_(std::move(make_guide)) {}

PlanningResult LacamPlanner::plan(const Instance& instance, const PlanningLimits& limits,
                                  Rng& rng) const {
  const Deadline deadline(limits.time_limit_s);
  const SearchProblem problem(instance);
  const auto guide = make_guide_(problem, instance, limits.threads, rng);
  FirstSolution first = findSolutionToImprove(problem, *guide, deadline, rng);
  PlanningResult result;
  result.statistics.first_solution_s = deadline.elapsed();
  result.statistics.search_nodes = first.nodes;
  std::vector<Vertices> best = std::move(first.plan);
  if (first.status == Lacam::Status::Solved && !limits.first_solution_only) {
    const Deadline rest(deadline.remaining() - socialStatesAtMost_s(*guide, deadline, best.size()));
    Improvement improvement =
        improve(problem, std::move(best), makeDistanceGenerator, limits.threads, rest, rng);
    best = std::move(improvement.plan);
    result.statistics.improvements = improvement.improvements;
    result.statistics.search_nodes += improvement.nodes;
  }
  result.plan = problem.graph.toPlan(best);
  result.outcome = outcomeOf(first.status, result.plan.size(), limits);
  result.social = guide->socialStates(best);
  result.statistics.policy_calls = guide->policyCalls();
  result.statistics.total_s = deadline.elapsed();
  return result;
}

}  // namespace sylph
