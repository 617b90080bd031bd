#include "sylph_core/search/policy_generator.hpp"

#include <cmath>
#include <utility>

#include "sylph_core/search/pibt_steps.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

std::vector<double> distancesFromStart(const SearchProblem& problem) {
  std::vector<double> distances;
  distances.reserve(problem.starts.size());
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    distances.push_back(problem.distances.get(agent, problem.starts[agent]));
  }
  return distances;
}

/// Large for selfish agents; `distances` settle what is equal. SVOs change from step to step, and
/// agents that take the lead by turns may get nowhere: who has a high priority is guided by
/// distance alone.
std::vector<double> selfishFirst(const std::vector<float>& svo_deg, const Priorities& priorities,
                                 const std::vector<double>& distances) {
  // PIBT solves what it solves since an agent stays first until it arrives.
  constexpr int kLongWait = 30;      // [timesteps]
  constexpr double kPerLevel = 1e9;  // more than any distance
  std::vector<double> tie_breaks = distances;
  for (std::size_t agent = 0; agent < svo_deg.size(); ++agent) {
    if (priorities[agent] < kLongWait) {
      tie_breaks[agent] -=
          kPerLevel * std::round(static_cast<double>(svo_deg[agent]) / kSvoLevelSpacingDeg);
    }
  }
  return tie_breaks;
}

/// By the network at first, by distance once its patience is over.
class PolicyGuidedSteps : public JointSteps {
 public:
  PolicyGuidedSteps(PibtSteps by_distance, PolicyRanking ranking, Pibt& pibt,
                    const Vertices& configuration, int patience)
      : by_distance_(std::move(by_distance)),
        ranking_(std::move(ranking)),
        pibt_(&pibt),
        configuration_(&configuration),
        patience_(patience) {}

  const std::vector<AgentId>& order() const override { return by_distance_.order(); }

  bool generate(Vertices& to) override {
    if (made_ >= patience_) {
      return by_distance_.generate(to);
    }
    ++made_;
    return pibt_->step(*configuration_, order(), ranking_, to);
  }

 private:
  PibtSteps by_distance_;
  PolicyRanking ranking_;
  Pibt* pibt_;
  const Vertices* configuration_;
  int patience_;
  int made_ = 0;
};

}  // namespace

PolicyGenerator::PolicyGenerator(const SearchProblem& problem, PolicySteps& steps,
                                 const MoveSettings& settings, const PolicyPatience& patience,
                                 Rng& rng)
    : problem_(&problem),
      steps_(&steps),
      settings_(settings),
      patience_(patience),
      rng_(&rng),
      distance_ranking_(problem.distances, rng),
      pibt_(problem),
      start_distances_(distancesFromStart(problem)) {}

std::unique_ptr<JointSteps> PolicyGenerator::enter(const Vertices& configuration,
                                                   const Vertices* before,
                                                   const Priorities& priorities) {
  // A call of the network costs as much as hundreds of steps by distance.
  if (!isWorthAsking(configuration)) {
    return std::make_unique<PibtSteps>(pibt_, distance_ranking_, configuration,
                                       orderByPriority(priorities, start_distances_));
  }
  const PolicyStep& step = steps_->enter(configuration, before, StepUse::Search).step;
  const std::vector<double> tie_breaks =
      selfishFirst(step.social.svo_deg, priorities, start_distances_);
  return std::make_unique<PolicyGuidedSteps>(
      PibtSteps(pibt_, distance_ranking_, configuration, orderByPriority(priorities, tie_breaks)),
      PolicyRanking(*problem_, settings_, step.by_cost, priorities, *rng_), pibt_, configuration,
      patience_.steps);
}

bool PolicyGenerator::isWorthAsking(const Vertices& configuration) {
  const long to_go = problem_->distances.sum(configuration);
  if (to_go < least_to_go_) {
    least_to_go_ = to_go;
    since_nearer_ = 0;
  } else {
    ++since_nearer_;
  }
  return since_nearer_ <= patience_.configurations &&
         steps_->count() * problem_->agentCount() < patience_.agent_steps;
}

}  // namespace sylph
