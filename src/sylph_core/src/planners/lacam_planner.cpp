#include "sylph_core/planners/lacam_planner.hpp"

#include <algorithm>
#include <utility>

#include "sylph_core/planners/first_solution.hpp"
#include "sylph_core/planners/improvement.hpp"
#include "sylph_core/search/cost_bound.hpp"
#include "sylph_core/search/distance_generator.hpp"
#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/paths.hpp"

namespace sylph {
namespace {

constexpr ImprovementSettings kSettings{};

Outcome outcomeOf(Lacam::Status status) {
  switch (status) {
    case Lacam::Status::Exhausted:
      return Outcome::Unsolvable;
    case Lacam::Status::Unfinished:
      return Outcome::TimeLimit;
    case Lacam::Status::Solved:
      break;
  }
  return Outcome::Solved;
}

/// The second attempt is policy-guided, the others are guided by distance.
FirstSolution findBySomeOrder(const SearchProblem& problem, Guide& guide, const Deadline& deadline,
                              Rng& rng) {
  const auto make_generator = [&](const SearchProblem& /*problem*/, int attempt, Rng& /*rng*/) {
    // Distance first, since it mostly solves within milliseconds; the policy solves some worlds
    // that no order of distance does.
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

/// A solution by the policy, within its share of the time. After a few steps it is known how long
/// as many as the solution by distance has would take: where that is too long it is given up at
/// once, and improvement has the time.
/// @param lacam  guided by the policy, from its first step on
Lacam::Status searchByPolicy(Lacam& lacam, std::size_t steps_by_distance,
                             const Deadline& deadline) {
  const Deadline turn = deadline.within(kSettings.policy_share * deadline.remaining());
  const double time_s = turn.remaining();
  const Lacam::Status status = lacam.search(turn, kSettings.measured_policy_steps);
  const double step_s = turn.elapsed() / static_cast<double>(kSettings.measured_policy_steps);
  if (status != Lacam::Status::Unfinished ||
      step_s * static_cast<double>(steps_by_distance) > time_s) {
    return status;
  }
  return lacam.search(turn, kSettings.most_policy_steps - kSettings.measured_policy_steps);
}

/// By distance a solution mostly is a matter of milliseconds. It is what there is if the network is
/// too slow for the time limit, or leads to something worse.
Solutions findSolutions(const SearchProblem& problem, Guide& guide, const Deadline& deadline,
                        Rng& rng) {
  FirstSolution first = guide.isPolicyGuided()
                            ? findBySomeOrder(problem, guide, deadline, rng)
                            : findFirstSolution(problem, makeDistanceGenerator, deadline, rng);
  Solutions solutions{first.status, {std::move(first.plan)}, first.nodes};
  if (solutions.status != Lacam::Status::Solved || !guide.isPolicyGuided() ||
      guide.policyCalls() > 0) {
    return solutions;
  }
  const auto generator = guide.makeGenerator();
  Lacam lacam(problem, *generator, rng);
  const auto status = searchByPolicy(lacam, solutions.plans.front().size() - 1, deadline);
  solutions.nodes += lacam.nodeCount();
  if (status == Lacam::Status::Solved) {
    solutions.plans.push_back(lacam.plan());
    if (costOf(solutions.plans.back()) <= costOf(solutions.plans.front())) {
      std::swap(solutions.plans.front(), solutions.plans.back());
    }
  }
  return solutions;
}

/// In rounds where they are worth it, see ImprovementSettings.
/// @param first_solution_s     when there was the first one, by the deadline's clock
/// @param reserve_s            time to leave for what comes after [s]
/// @param proved_sum_of_costs  as improve() has it
Improvement improveSolutions(const SearchProblem& problem,
                             const std::vector<std::vector<Vertices>>& plans, int threads,
                             const Deadline& deadline, double first_solution_s, double reserve_s,
                             long proved_sum_of_costs, Rng& rng) {
  const bool has_rounds =
      plans.size() > 1 && problem.agentCount() <= kSettings.most_agents_of_rounds &&
      first_solution_s < kSettings.most_first_solution_share * deadline.remaining();
  const int rounds = has_rounds ? kSettings.rounds : 1;
  Improvement best;
  for (int round = 0; round < rounds; ++round) {
    const Deadline turn = deadline.within((deadline.remaining() - reserve_s) / (rounds - round));
    Improvement improvement =
        improve(problem, plans[static_cast<std::size_t>(round) % plans.size()],
                makeDistanceGenerator, threads, turn, rng, proved_sum_of_costs);
    improvement.improvements += best.improvements;
    improvement.nodes += best.nodes;
    if (round > 0 && costOf(best.plan) < costOf(improvement.plan)) {
      improvement.plan = std::move(best.plan);
    }
    best = std::move(improvement);
    // It ended of its own accord.
    if (!turn.isOver()) {
      break;  // the least cost
    }
  }
  return best;
}

/// Improvement leaves this time for the social states along its plan [s]. It is estimated from the
/// network's calls so far, or from the first steps of a plan.
double timeForSocialStates(Guide& guide, const std::vector<Vertices>& plan,
                           const Deadline& deadline) {
  const auto steps = static_cast<double>(plan.size() - 1);
  double time_s = 0.0;
  if (guide.policyCalls() > 0) {
    time_s = deadline.elapsed() / static_cast<double>(guide.policyCalls()) * steps;
  } else {
    const auto measure = [&](int count) {
      const double begin_s = deadline.elapsed();
      guide.socialStates(
          {plan.begin(), plan.begin() + std::min<long>(count + 1, static_cast<long>(plan.size()))},
          deadline);
      return deadline.elapsed() - begin_s;
    };
    const double first_s = measure(1);  // dearer than the ones that follow
    const int count = kSettings.measured_social_steps;
    time_s = first_s + (measure(count) - first_s) / (count - 1.0) * steps;
  }
  const double most_s = std::max(0.0, kSettings.most_social_share * deadline.remaining());
  return std::clamp(time_s, kSettings.least_social_share * most_s, most_s);
}

}  // namespace

SearchResult LacamPlanner::search(const SearchProblem& problem, Guide& guide,
                                  const PlanningLimits& limits, const Deadline& deadline, Rng& rng,
                                  PlanningStatistics& statistics) const {
  Solutions solutions = findSolutions(problem, guide, deadline, rng);
  statistics.first_solution_s = deadline.elapsed();
  statistics.search_nodes = solutions.nodes;
  SearchResult result{outcomeOf(solutions.status), solutions.plans.front()};
  if (solutions.status == Lacam::Status::Solved && !limits.first_solution_only) {
    const double reserve_s =
        limits.social_states ? timeForSocialStates(guide, result.plan, deadline) : 0.0;
    const long proved = provedSumOfCosts(
        problem, costOf(result.plan),
        deadline.within(kSettings.proof_share * (deadline.remaining() - reserve_s)), kSettings);
    Improvement improvement = improveSolutions(problem, solutions.plans, limits.threads, deadline,
                                               statistics.first_solution_s, reserve_s, proved, rng);
    result.plan = std::move(improvement.plan);
    statistics.proved_sum_of_costs = improvement.is_least ? costOf(result.plan) : proved;
    statistics.improvements = improvement.improvements;
    statistics.search_nodes += improvement.nodes;
  }
  return result;
}

}  // namespace sylph
