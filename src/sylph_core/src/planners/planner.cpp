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

void ablate(PolicySettings& settings, const std::string& ablation) {
  static const std::map<std::string, SvoChoice> kSvoChoices = {
      {"svo_by_priority", SvoChoice::Priority},
      {"random_svo_per_step", SvoChoice::RandomPerStep},
      {"random_svo_per_episode", SvoChoice::RandomPerEpisode},
      {"random_svo_per_partner", SvoChoice::RandomPerPartner}};
  const auto choice = kSvoChoices.find(ablation);
  if (choice != kSvoChoices.end()) {
    settings.svo_choice = choice->second;
  } else if (ablation == "random_tie_breaking") {
    settings.breaks_ties_by_svo = false;
  } else {
    throw std::invalid_argument("ablation '" + ablation + "' is unknown: must be one of " +
                                join(ablationNames()));
  }
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

std::unique_ptr<Planner> makePlanner(const std::string& name, std::shared_ptr<const Policy> policy,
                                     const std::string& ablation) {
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
  PolicySettings settings = defaultSettings(use->second, has_cost_network);
  std::string full_name = name;
  if (!ablation.empty()) {
    ablate(settings, ablation);
    full_name += "/" + ablation;
  }
  GuideFactory make_guide = makePolicyGuideFactory(std::move(policy), use->second, settings);
  if (use->second == PolicyUse::Search) {
    return std::make_unique<LacamPlanner>(full_name, std::move(make_guide));
  }
  return std::make_unique<StepwisePlanner>(full_name, std::move(make_guide));
}

}  // namespace sylph
