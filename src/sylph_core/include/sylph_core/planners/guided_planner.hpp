#pragma once

#include <string>
#include <vector>

#include "sylph_core/planners/guide.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// What a search came to.
struct SearchResult {
  Outcome outcome = Outcome::TimeLimit;
  std::vector<Vertices> plan;  ///< a solution, or as far as the search came
};

/// What all planners have in common: a search with a guide, and what is said of its plan.
class GuidedPlanner : public Planner {
 public:
  /// @param name  by which makePlanner() knows it
  GuidedPlanner(std::string name, GuideFactory make_guide);

  PlanningResult plan(const Instance& instance, const PlanningLimits& limits,
                      Rng& rng) const override;
  std::string name() const override { return name_; }

 private:
  /// @param problem     with the distances from the starts known
  /// @param statistics  out: what the search knows of it
  virtual SearchResult search(const SearchProblem& problem, Guide& guide,
                              const PlanningLimits& limits, const Deadline& deadline, Rng& rng,
                              PlanningStatistics& statistics) const = 0;

  std::string name_;
  GuideFactory make_guide_;
};

}  // namespace sylph
