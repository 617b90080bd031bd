#include "sylph_core/planners/policy_guide.hpp"

#include <utility>

#include "sylph_core/search/policy_generator.hpp"
#include "sylph_core/search/policy_steps.hpp"
#include "sylph_core/search/tie_breaking_generator.hpp"

namespace sylph {
namespace {

constexpr double kDistanceFirst = 100.0;  // more than any difference of logits
constexpr PolicyPatience kPatienceOfSearch = {50, 3, 1'000'000};

/// Where agents get no nearer with the network, PIBT by distance takes them out of it.
PolicyPatience patienceOfPibt() {
  PolicyPatience patience;
  patience.configurations = 20;
  return patience;
}

class PolicyGuide : public Guide {
 public:
  PolicyGuide(std::shared_ptr<const Policy> policy, PolicyUse use, const PolicySettings& settings,
              const SearchProblem& problem, const Instance& instance, int threads, Rng& rng)
      : policy_(std::move(policy)),
        use_(use),
        settings_(settings),
        problem_(&problem),
        grid_(&instance.grid),
        rng_(&rng),
        tie_breaks_(rng),
        rollout_(*policy_, instance.grid, problem.distances.fields(), settings.svo_choice, threads,
                 tie_breaks_),
        steps_(rollout_, problem.graph, rng) {}

  std::unique_ptr<ConfigurationGenerator> makeGenerator() override {
    if (use_ == PolicyUse::TieBreaking) {
      return std::make_unique<TieBreakingGenerator>(*problem_, *grid_, steps_, settings_.moves,
                                                    settings_.breaks_ties_by_svo, *rng_);
    }
    return std::make_unique<PolicyGenerator>(
        *problem_, steps_, settings_.moves,
        use_ == PolicyUse::Search ? kPatienceOfSearch : patienceOfPibt(), *rng_);
  }

  bool isPolicyGuided() const override { return true; }

  std::vector<SocialState> socialStates(const std::vector<Vertices>& plan,
                                        const Deadline& deadline) override {
    return steps_.along(plan, deadline);
  }

  long policyCalls() const override { return rollout_.calls(); }

 private:
  std::shared_ptr<const Policy> policy_;
  PolicyUse use_;
  PolicySettings settings_;
  const SearchProblem* problem_;
  const Grid* grid_;
  Rng* rng_;
  Rng tie_breaks_;  // a copy: the planner draws what it would draw without a policy
  PolicyRollout rollout_;
  PolicySteps steps_;
};

}  // namespace

PolicySettings defaultSettings(PolicyUse use, bool has_cost_network) {
  PolicySettings settings;
  if (use == PolicyUse::TieBreaking) {
    settings.moves = {0.0, 0.0, 0.7, 1.0, 1.0};  // draws from the policy
    return settings;
  }
  // The policy gives way by itself. So does PIBT, whatever agents want, and where they want away
  // from their goals it pushes others for it: so distance comes first, the policy settles which of
  // the equally short moves to take, and who waits long leaves it to chance.
  settings.moves.distance_weight = kDistanceFirst;
  settings.moves.base_temperature = kDistanceFirst / 16.0;
  settings.moves.least_factor = 0.05;
  if (use == PolicyUse::Pibt) {
    // No search helps who goes round in circles: only chance does.
    settings.moves.base_temperature = kDistanceFirst / 10.0;
    settings.moves.most_factor = 4.0;
    if (has_cost_network) {
      // What is cheap may be a wait or a way round, where the network is sure.
      settings.moves.distance_weight = 20.0;
      settings.moves.base_temperature = 1.0;
    }
  }
  return settings;
}

GuideFactory makePolicyGuideFactory(std::shared_ptr<const Policy> policy, PolicyUse use,
                                    const PolicySettings& settings) {
  return [policy = std::move(policy), use, settings](
             const SearchProblem& problem, const Instance& instance, int threads, Rng& rng) {
    return std::make_unique<PolicyGuide>(policy, use, settings, problem, instance, threads, rng);
  };
}

}  // namespace sylph
