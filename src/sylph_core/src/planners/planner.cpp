#include "sylph_core/planners/planner.hpp"

#include <stdexcept>

#include "sylph_core/planners/lacam_planner.hpp"
#include "sylph_core/planners/pibt_planner.hpp"
#include "sylph_core/search/distance_generator.hpp"

namespace sylph {

std::string toString(Outcome outcome) {
  switch (outcome) {
    case Outcome::Solved:
      return "solved";
    case Outcome::TimeLimit:
      return "time limit";
    case Outcome::StepLimit:
      return "step limit";
    case Outcome::Unsolvable:
      return "unsolvable";
  }
  return "unknown";
}

const std::vector<std::string>& plannerNames() {
  static const std::vector<std::string> kNames = {"lacam", "pibt"};
  return kNames;
}

std::unique_ptr<Planner> makePlanner(const std::string& name) {
  if (name == "lacam") {
    return std::make_unique<LacamPlanner>(name, makeDistanceGenerator);
  }
  if (name == "pibt") {
    return std::make_unique<PibtPlanner>(name, makeDistanceGenerator);
  }
  std::string allowed;
  for (const std::string& known : plannerNames()) {
    allowed += (allowed.empty() ? "" : ", ") + known;
  }
  throw std::invalid_argument("planner '" + name + "' is unknown: must be one of " + allowed);
}

}  // namespace sylph
