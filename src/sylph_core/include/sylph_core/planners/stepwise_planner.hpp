#pragma once

#include <string>

#include "sylph_core/planners/guide.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// One joint step of a generator after the other until everybody is on its goal. Fast and
/// incomplete: agents can go round in circles until the step or time limit.
class StepwisePlanner : public Planner {
 public:
  StepwisePlanner(std::string name, GuideFactory make_guide);

  PlanningResult plan(const Instance& instance, const PlanningLimits& limits,
                      Rng& rng) const override;
  std::string name() const override { return name_; }

 private:
  std::string name_;
  GuideFactory make_guide_;
};

}  // namespace sylph
