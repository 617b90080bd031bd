#include "sylph_core/planners/lacam_planner.hpp"

#include <utility>

#include "sylph_core/planners/first_solution.hpp"
#include "sylph_core/planners/improvement.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/paths.hpp"

namespace sylph {
namespace {

constexpr double kShareOfPolicy = 0.25;  // of the time, at most, where there is a solution
constexpr long kStepsOfPolicy = 1000;
constexpr int kFewAgents = 16;
constexpr double kShareOfFirstSolution = 0.05;  // of the rest of the time, at most, for rounds
constexpr int kRoundsOfFew = 4;

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

long costOf(const std::vector<Vertices>& plan) {
  return sumOfCosts(pathsOf(plan));
}

struct Solutions {
  Lacam::Status status = Lacam::Status::Unfinished;
  /// The cheapest first; if there is no solution, the way to the nearest configuration found.
  std::vector<std::vector<Vertices>> plans;
  long nodes = 0;  ///< configurations generated
};

/// By distance a solution mostly is a matter of milliseconds. It is what there is if the network is
/// too slow for the time limit, or leads to something worse.
Solutions findSolutions(const SearchProblem& problem, Guide& guide, const Deadline& deadline,
                        Rng& rng) {
  FirstSolution first = guide.goesByDistance()
                            ? findFirstSolution(problem, makeDistanceGenerator, deadline, rng)
                            : findBySomeOrder(problem, guide, deadline, rng);
  Solutions solutions{first.status, {std::move(first.plan)}, first.nodes};
  if (solutions.status != Lacam::Status::Solved || guide.goesByDistance() ||
      guide.policyCalls() > 0) {
    return solutions;
  }
  const auto generator = guide.makeGenerator();
  Lacam lacam(problem, *generator, rng);
  const auto status = lacam.search(Deadline(kShareOfPolicy * deadline.remaining()), kStepsOfPolicy);
  solutions.nodes += lacam.nodeCount();
  if (status == Lacam::Status::Solved) {
    solutions.plans.push_back(lacam.plan());
    if (costOf(solutions.plans.back()) <= costOf(solutions.plans.front())) {
      std::swap(solutions.plans.front(), solutions.plans.back());
    }
  }
  return solutions;
}

/// Few agents soon are in a local optimum; other starts then are worth more than time, unless the
/// computer is so busy that there is little of it.
/// @param reserve_s  time to leave for what comes after [s]
Improvement improveSolutions(const SearchProblem& problem,
                             const std::vector<std::vector<Vertices>>& plans, int threads,
                             const Deadline& deadline, double reserve_s, Rng& rng) {
  const bool has_rounds = plans.size() > 1 && problem.agentCount() <= kFewAgents &&
                          deadline.elapsed() < kShareOfFirstSolution * deadline.remaining();
  const int rounds = has_rounds ? kRoundsOfFew : 1;
  Improvement best;
  for (int round = 0; round < rounds; ++round) {
    const Deadline turn((deadline.remaining() - reserve_s) / (rounds - round));
    Improvement improvement =
        improve(problem, plans[static_cast<std::size_t>(round) % plans.size()],
                makeDistanceGenerator, threads, turn, rng);
    improvement.improvements += best.improvements;
    improvement.nodes += best.nodes;
    if (round > 0 && costOf(best.plan) < costOf(improvement.plan)) {
      improvement.plan = std::move(best.plan);
    }
    best = std::move(improvement);
    if (!turn.isOver()) {
      break;  // the least cost
    }
  }
  return best;
}

/// Improvement leaves this time for the network to be asked along the plan [s].
double timeForSocialStates(const Guide& guide, const Deadline& deadline, std::size_t steps) {
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
  Solutions solutions = findSolutions(problem, *guide, deadline, rng);
  PlanningResult result;
  result.statistics.first_solution_s = deadline.elapsed();
  result.statistics.search_nodes = solutions.nodes;
  std::vector<Vertices> best = solutions.plans.front();
  if (solutions.status == Lacam::Status::Solved && !limits.first_solution_only) {
    Improvement improvement =
        improveSolutions(problem, solutions.plans, limits.threads, deadline,
                         timeForSocialStates(*guide, deadline, best.size()), rng);
    best = std::move(improvement.plan);
    result.statistics.improvements = improvement.improvements;
    result.statistics.search_nodes += improvement.nodes;
  }
  result.plan = problem.graph.toPlan(best);
  result.outcome = outcomeOf(solutions.status, result.plan.size(), limits);
  result.social = guide->socialStates(best);
  result.statistics.policy_calls = guide->policyCalls();
  result.statistics.total_s = deadline.elapsed();
  return result;
}

}  // namespace sylph
