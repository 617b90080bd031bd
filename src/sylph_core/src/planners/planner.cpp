#include "sylph_core/planners/planner.hpp"

#include <map>
#include <stdexcept>
#include <utility>

#include "sylph_core/planners/lacam_planner.hpp"
#include "sylph_core/planners/policy_guide.hpp"
#include "sylph_core/planners/stepwise_planner.hpp"
#include "sylph_core/text/join.hpp"

namespace sylph {
namespace {

const std::map<std::string, PolicyUse>& policyUses() {
  static const std::map<std::string, PolicyUse> kUses = {{"sylph", PolicyUse::TieBreaking},
                                                         {"sylph_pibt", PolicyUse::Pibt},
                                                         {"sylph_lacam", PolicyUse::Search}};
  return kUses;
}

}  // namespace

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

bool needsPolicy(const std::string& planner_name) {
  return policyUses().count(planner_name) > 0;
}

std::shared_ptr<const Policy> loadPolicyFor(const std::string& planner_name,
                                            const std::string& weights_path) {
  if (!needsPolicy(planner_name)) {
    return nullptr;
  }
  if (weights_path.empty()) {
    throw std::invalid_argument("planner '" + planner_name + "' needs the weights of a policy");
  }
  return std::make_shared<const Policy>(Policy::load(weights_path));
}

std::unique_ptr<Planner> makePlanner(const std::string& name,
                                     std::shared_ptr<const Policy> policy) {
  if (name == "lacam") {
    return std::make_unique<LacamPlanner>(name, makeDistanceGuide);
  }
  if (name == "pibt") {
    return std::make_unique<StepwisePlanner>(name, makeDistanceGuide);
  }
  const auto use = policyUses().find(name);
  if (use == policyUses().end()) {
    throw std::invalid_argument("planner '" + name + "' is unknown: must be one of " +
                                join(plannerNames()));
  }
  if (policy == nullptr) {
    throw std::invalid_argument("planner '" + name + "' needs the weights of a policy");
  }
  const bool has_cost_network = policy->costNetwork() != nullptr;
  GuideFactory make_guide = makePolicyGuideFactory(std::move(policy), use->second,
                                                   defaultSettings(use->second, has_cost_network));
  if (use->second == PolicyUse::Search) {
    return std::make_unique<LacamPlanner>(name, std::move(make_guide));
  }
  return std::make_unique<StepwisePlanner>(name, std::move(make_guide));
}

}  // namespace sylph
