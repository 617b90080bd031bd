#include "sylph_core/planners/improvement.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include "sylph_core/search/lacam.hpp"
#include "sylph_core/search/large_neighborhood_search.hpp"
#include "sylph_core/search/paths.hpp"

namespace sylph {
namespace {

/// One large-neighbourhood search per thread.
class Workers {
 public:
  Workers(const SearchProblem& problem, const std::vector<Vertices>& plan, long proved_sum_of_costs,
          const ImprovementSettings& settings, int threads, Rng& rng) {
    for (int thread = 0; thread < threads; ++thread) {
      searches_.push_back(
          std::make_unique<LargeNeighborhoodSearch>(problem, plan, proved_sum_of_costs, settings));
      // One thread draws as the caller would: a plan of one thread depends on the seed alone.
      rngs_.emplace_back(thread == 0 ? rng : Rng(rng()));
    }
  }

  void run(const Deadline& deadline, double temperature) {
    std::vector<std::thread> threads;
    for (std::size_t worker = 1; worker < searches_.size(); ++worker) {
      threads.emplace_back([this, worker, &deadline, temperature] {
        searches_[worker]->run(deadline, temperature, rngs_[worker]);
      });
    }
    searches_.front()->run(deadline, temperature, rngs_.front());
    for (std::thread& thread : threads) {
      thread.join();
    }
    // The best plan is where all go on: differences between threads are luck.
    if (searches_.size() > 1 && !deadline.isOver()) {
      offer(best().plan());
    }
  }

  /// Goes on from another plan where that is better.
  void offer(const std::vector<Vertices>& plan) {
    for (const auto& search : searches_) {
      search->offer(plan);
    }
  }

  const LargeNeighborhoodSearch& best() const {
    return **std::min_element(searches_.begin(), searches_.end(),
                              [](const auto& a, const auto& b) { return a->cost() < b->cost(); });
  }

 private:
  std::vector<std::unique_ptr<LargeNeighborhoodSearch>> searches_;
  std::vector<Rng> rngs_;
};

/// LaCAM* beside the large-neighbourhood search. It gets a share of the time that depends on how
/// much it can see of the configurations of that many agents.
class Rewiring {
 public:
  Rewiring(const SearchProblem& problem, const GeneratorFactory& make_generator,
           const ImprovementSettings& settings, Rng& rng)
      : generator_(make_generator(problem, 0, rng)),
        lacam_(problem, *generator_, rng),
        agents_(problem.agentCount()),
        share_(agents_ <= settings.few_agents ? settings.lacam_share_of_few : settings.lacam_share),
        most_vertices_kept_(settings.most_vertices_kept) {}

  enum class Result { Nothing, Better, Optimal };

  /// @param plan, cost  the best plan so far and its sum of costs
  Result run(const std::vector<Vertices>& plan, long cost, const Deadline& deadline,
             double turn_s) {
    if (is_exhausted_ || deadline.isOver() || lacam_.nodeCount() * agents_ > most_vertices_kept_) {
      return Result::Nothing;
    }
    lacam_.insert(plan, deadline);
    const Lacam::Status status = lacam_.search(deadline.within(share_ * turn_s), kNoStepLimit);
    is_exhausted_ = status == Lacam::Status::Exhausted;
    // Exhausted, the cost is least in LaCAM's measure, which is at most the sum of costs.
    return is_exhausted_ && lacam_.isSolved() && lacam_.cost() == cost ? Result::Optimal
           : status == Lacam::Status::Solved                           ? Result::Better
                                                                       : Result::Nothing;
  }

  const Lacam& lacam() const { return lacam_; }

 private:
  static constexpr long kNoStepLimit = -1;

  std::unique_ptr<ConfigurationGenerator> generator_;
  Lacam lacam_;
  long agents_;
  double share_;
  long most_vertices_kept_;
  bool is_exhausted_ = false;
};

/// Searches anew from configurations of a plan, its start and others, as long as that now and then
/// finds a better way to the goals. Where agents are much in each other's way, depth-first search
/// may go round in circles for long, and no small neighbourhood mends that.
class Restarts {
 public:
  Restarts(const SearchProblem& problem, const GeneratorFactory& make_generator,
           const ImprovementSettings& settings, Rng& rng)
      : problem_(&problem), make_generator_(&make_generator), settings_(&settings), rng_(&rng) {}

  /// @param most_failures  in a row
  /// @return the plan, or a better one
  std::vector<Vertices> run(std::vector<Vertices> plan, int most_failures,
                            const Deadline& deadline) {
    long best_cost = sumOfCosts(pathsOf(plan));
    while (failures_ < most_failures && !deadline.isOver()) {
      std::vector<Vertices> candidate = searchFrom(plan, drawIndex(*rng_, plan.size()), deadline);
      const long cost = sumOfCosts(pathsOf(candidate));
      if (candidate.back() == problem_->goals && cost < best_cost) {
        best_cost = cost;
        plan = std::move(candidate);
        failures_ = 0;
      } else {
        ++failures_;
      }
    }
    return plan;
  }

 private:
  std::vector<Vertices> searchFrom(const std::vector<Vertices>& plan, std::size_t timestep,
                                   const Deadline& deadline) {
    const std::size_t begin = ++attempts_ % settings_->restarts_per_start == 0 ? 0 : timestep;
    const auto generator = (*make_generator_)(*problem_, attempts_, *rng_);
    Lacam lacam(*problem_, plan[begin], *generator, *rng_);
    lacam.search(deadline, settings_->steps_per_step * static_cast<long>(plan.size() - begin));
    std::vector<Vertices> candidate(plan.begin(), plan.begin() + static_cast<long>(begin));
    const std::vector<Vertices> rest = lacam.plan();
    candidate.insert(candidate.end(), rest.begin(), rest.end());
    return candidate;
  }

  const SearchProblem* problem_;
  const GeneratorFactory* make_generator_;
  const ImprovementSettings* settings_;
  Rng* rng_;
  int attempts_ = 0;
  int failures_ = 0;
};

}  // namespace

Improvement improve(const SearchProblem& problem, std::vector<Vertices> plan,
                    const GeneratorFactory& make_generator, int threads, const Deadline& deadline,
                    Rng& rng, long proved_sum_of_costs, const ImprovementSettings& settings) {
  const double time_s = deadline.remaining();
  const double turn_s = std::min(time_s / settings.turns, settings.longest_turn_s);
  const long lower_bound = std::max(proved_sum_of_costs, problem.distances.sum(problem.starts));
  Improvement improvement;
  if (deadline.isOver() || sumOfCosts(pathsOf(plan)) == lower_bound) {
    improvement.plan = std::move(plan);
    return improvement;
  }
  Restarts restarts(problem, make_generator, settings, rng);
  const double table_bytes =
      LargeNeighborhoodSearch::bytesOf(problem, static_cast<int>(plan.size()) - 1);
  const double affordable_bytes = std::min(
      settings.most_table_bytes, settings.table_share * time_s * settings.table_bytes_per_s);
  // On such maps to fill the table alone takes the time that there is.
  if (table_bytes > affordable_bytes) {
    improvement.plan = restarts.run(std::move(plan), std::numeric_limits<int>::max(), deadline);
    return improvement;
  }
  threads = std::min<int>(threads, static_cast<int>(affordable_bytes / table_bytes));
  if (threads > 1 &&
      !problem.distances.completeAll(deadline.within(settings.table_share * time_s))) {
    threads = 1;  // distances that are not complete cannot be shared
  }
  plan = restarts.run(std::move(plan), settings.most_failed_restarts,
                      deadline.within(settings.restart_share * time_s));
  Workers workers(problem, plan, proved_sum_of_costs, settings, threads, rng);
  Rewiring rewiring(problem, make_generator, settings, rng);
  bool is_descending = true;
  while (workers.best().cost() > lower_bound && !deadline.isOver()) {
    // Losses are accepted only once easy gains are over: before that they would only delay.
    const double cooling = deadline.remaining() / time_s;
    const long cost_before = workers.best().cost();
    workers.run(deadline.within(turn_s),
                is_descending ? 0.0 : settings.first_temperature * cooling);
    const LargeNeighborhoodSearch& best = workers.best();
    is_descending =
        is_descending && static_cast<double>(best.cost()) <
                             static_cast<double>(cost_before) * (1.0 - settings.plentiful_gain);
    const auto result = rewiring.run(best.plan(), best.cost(), deadline, turn_s);
    if (result == Rewiring::Result::Optimal) {
      improvement.is_least = true;
      break;
    }
    if (result == Rewiring::Result::Better) {
      workers.offer(rewiring.lacam().plan());
    }
  }
  improvement.plan = workers.best().plan();
  improvement.improvements = workers.best().improvementCount();
  improvement.nodes = rewiring.lacam().nodeCount();
  return improvement;
}

}  // namespace sylph
