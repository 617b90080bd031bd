#pragma once

#include <memory>
#include <string>

#include "sylph_core/planners/generator_factory.hpp"
#include "sylph_core/planners/planner.hpp"

namespace sylph {

/// LaCAM over the configurations of a generator, then improvement until the time is up. Complete:
/// finds a plan if there is one, given the time, and Unsolvable is a proof.
class LacamPlanner : public Planner {
 public:
  LacamPlanner(std::string name, GeneratorFactory make_generator);

  PlanningResult plan(const Instance& instance, const PlanningLimits& limits,
                      Rng& rng) const override;
  std::string name() const override { return name_; }

 private:
  std::string name_;
  GeneratorFactory make_generator_;
};

}  // namespace sylph
