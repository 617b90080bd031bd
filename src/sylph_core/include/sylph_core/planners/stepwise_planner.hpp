#pragma once

#include "sylph_core/planners/guided_planner.hpp"

namespace sylph {

/// One joint step of a generator after the other until all agents are on their goals. Fast and
/// incomplete: agents can go round in circles until the step or time limit.
class StepwisePlanner : public GuidedPlanner {
 public:
  using GuidedPlanner::GuidedPlanner;

 private:
  SearchResult search(const SearchProblem& problem, Guide& guide, const PlanningLimits& limits,
                      const Deadline& deadline, Rng& rng,
                      PlanningStatistics& statistics) const override;
};

}  // namespace sylph
