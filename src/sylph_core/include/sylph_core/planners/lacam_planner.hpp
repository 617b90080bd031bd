#pragma once

#include <string>

#include "sylph_core/planners/guide.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// LaCAM, then improvement by distance until the time is up. Complete: finds a plan if there is
/// one, given the time, and Unsolvable is a proof.
///
/// With a guide that goes by a policy, the first solution is the cheaper one of two: found by
/// distance, and found by the guide within a quarter of the time limit; for a few agents
/// improvement starts from the one and the other by turns. Where the first attempt by distance
/// finds none, the second attempt goes by the guide.
class LacamPlanner : public Planner {
 public:
  LacamPlanner(std::string name, GuideFactory make_guide);

  PlanningResult plan(const Instance& instance, const PlanningLimits& limits,
                      Rng& rng) const override;
  std::string name() const override { return name_; }

 private:
  std::string name_;
  GuideFactory make_guide_;
};

}  // namespace sylph
