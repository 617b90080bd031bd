#pragma once

#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/improvement_settings.hpp"
#include "sylph_core/search/neighborhoods.hpp"
#include "sylph_core/search/path_search.hpp"
#include "sylph_core/search/paths.hpp"
#include "sylph_core/search/reservation_table.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// Improves a solution by planning the paths of a few agents anew, one after the other, again and
/// again. Which agents, and how many, is learned: kinds and sizes of neighbourhood are drawn in
/// proportion to what they gained per second of late.
///
/// Li et al. 2021, "Anytime Multi-Agent Path Finding via Large Neighborhood Search". Differs in
/// that some losses are accepted, as in simulated annealing.
class LargeNeighborhoodSearch {
 public:
  /// @param plan                 a legal plan that ends on the goals
  /// @param problem              must outlive this object; its distances are complete if threads
  ///                             share them
  /// @param proved_sum_of_costs  no plan has less, besides the sum of distances
  LargeNeighborhoodSearch(const SearchProblem& problem, const std::vector<Vertices>& plan,
                          long proved_sum_of_costs = 0, const ImprovementSettings& settings = {});

  // The neighbourhoods refer to the table.
  LargeNeighborhoodSearch(const LargeNeighborhoodSearch&) = delete;
  LargeNeighborhoodSearch& operator=(const LargeNeighborhoodSearch&) = delete;

  /// Goes on until the time is up or no plan can be better.
  /// @param temperature  loss in cost accepted on average, >= 0
  void run(const Deadline& deadline, double temperature, Rng& rng);

  /// Memory of a search that begins with a plan of a makespan.
  static double bytesOf(const SearchProblem& problem, int makespan);

  /// Goes on from another legal plan if that is better than plan().
  void offer(const std::vector<Vertices>& plan);

  /// The best plan so far.
  std::vector<Vertices> plan() const { return planOf(best_paths_); }
  /// Its sum of costs.
  long cost() const { return best_cost_; }
  /// Times a better plan was found.
  long improvementCount() const { return improvements_; }

 private:
  struct Arm {
    NeighborhoodKind kind;
    int size;
    double gain_per_s = 1.0;
  };

  std::size_t drawArm(Rng& rng) const;
  bool replan(std::vector<AgentId> agents, long allowed_loss, const Deadline& deadline, Rng& rng);
  bool planAll(const std::vector<AgentId>& agents, long max_cost, const Deadline& deadline,
               Rng& rng);
  void take(std::vector<VertexPath> paths);
  void fillTable(const std::vector<VertexPath>& paths);
  void shrinkTable();
  void keepIfBest();
  int costOf(AgentId agent) const { return static_cast<int>(table_.path(agent).size()) - 1; }
  int leastCostOf(AgentId agent) const {
    return problem_->distances.get(agent, problem_->starts[agent]);
  }

  const SearchProblem* problem_;
  ImprovementSettings settings_;
  ReservationTable table_;
  PathSearch search_;
  Neighborhoods neighborhoods_;
  std::vector<Arm> arms_;
  long lower_bound_;
  long cost_ = 0;
  long best_cost_ = 0;
  std::vector<VertexPath> best_paths_;
  long improvements_ = 0;
};

}  // namespace sylph
