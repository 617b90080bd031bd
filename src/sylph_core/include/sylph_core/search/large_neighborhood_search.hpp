#pragma once

#include <array>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/search/deadline.hpp"
#include "sylph_core/search/neighborhoods.hpp"
#include "sylph_core/search/path_search.hpp"
#include "sylph_core/search/reservation_table.hpp"
#include "sylph_core/search/search_problem.hpp"

namespace sylph {

/// Improves a solution by planning the paths of a few agents anew, again and again.
class LargeNeighborhoodSearch {
 public:
  /// @param plan     a legal plan that ends on the goals
  /// @param problem  must outlive this object
  LargeNeighborhoodSearch(const SearchProblem& problem, const std::vector<Vertices>& plan);

  /// Goes on until the time is up or all agents go their shortest way.
  void run(const Deadline& deadline, Rng& rng);

  std::vector<Vertices> plan() const;
  /// Sum of costs of plan().
  long cost() const { return cost_; }
  /// Times the cost went down.
  long improvementCount() const { return improvements_; }
  long iterationCount() const { return iterations_; }

 private:
  struct Arm {
    NeighborhoodKind kind;
    int size;
    double weight = 1.0;
  };

  std::size_t drawArm(Rng& rng) const;
  bool improve(std::vector<AgentId> agents, Rng& rng);
  int costOf(AgentId agent) const { return static_cast<int>(table_.path(agent).size()) - 1; }

  const SearchProblem* problem_;
  ReservationTable table_;
  PathSearch search_;
  Neighborhoods neighborhoods_;
  std::vector<Arm> arms_;
  long cost_ = 0;
  long lower_bound_ = 0;
  long improvements_ = 0;
  long iterations_ = 0;
};

}  // namespace sylph
