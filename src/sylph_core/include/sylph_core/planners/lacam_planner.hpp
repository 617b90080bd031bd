#pragma once

#include "sylph_core/planners/guided_planner.hpp"

namespace sylph {

/// LaCAM, then improvement by distance until the time is up. Complete: finds a plan if there is
/// one, given the time, and Unsolvable is a proof.
///
/// Policy-guided, the first solution is the cheaper one of two: found by distance, and found by the
/// policy within a twentieth of the time that is left, if its first steps are fast enough for that;
/// for a few agents improvement starts from the one and the other by turns. Where the first attempt
/// by distance finds none, the second attempt is policy-guided.
class LacamPlanner : public GuidedPlanner {
 public:
  using GuidedPlanner::GuidedPlanner;

 private:
  SearchResult search(const SearchProblem& problem, Guide& guide, const PlanningLimits& limits,
                      const Deadline& deadline, Rng& rng,
                      PlanningStatistics& statistics) const override;
};

}  // namespace sylph
