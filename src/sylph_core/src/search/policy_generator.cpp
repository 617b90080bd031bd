#include "sylph_core/search/policy_generator.hpp"

#include <cmath>

#include "sylph_core/search/pibt_generator.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

std::vector<double> distancesFromStart(const SearchProblem& problem) {
  std::vector<double> distances;
  for (AgentId agent = 0; agent < problem.agentCount(); ++agent) {
    distances.push_back(problem.distances.get(agent, problem.starts[agent]));
  }
  return distances;
}

/// Large for selfish agents; `distances` settle what is equal. SVOs change from step to step, and
/// agents that take the lead by turns may get nowhere: who has waited long goes by distance alone.
std::vector<double> selfishFirst(const std::vector<float>& svo_deg, const std::vector<int>& waited,
                                 const std::vector<double>& distances) {
  constexpr int kLongWait = 30;      // [timesteps]
  constexpr double kPerLevel = 1e9;  // more than any distance
  std::vector<double> tie_breaks = distances;
  for (std::size_t agent = 0; agent < svo_deg.size(); ++agent) {
    if (waited[agent] < kLongWait) {
      tie_breaks[agent] -=
          kPerLevel * std::round(static_cast<double>(svo_deg[agent]) / kSvoLevelSpacingDeg);
    }
  }
  return tie_breaks;
}

}  // namespace

PolicyGenerator::PolicyGenerator(const SearchProblem& problem, PolicySteps& steps,
                                 const MoveSettings& settings, const PolicyPatience& patience,
                                 Rng& rng)
    : problem_(&problem),
      steps_(&steps),
      patience_(patience),
      policy_ranking_(problem, settings, rng),
      distance_ranking_(problem.distances, rng),
      pibt_(problem.graph, problem.goals, problem.distances, problem.motion),
      start_distances_(distancesFromStart(problem)) {}

std::vector<AgentId> PolicyGenerator::order(const Vertices& configuration, const Vertices* before,
                                            const std::vector<int>& waited) {
  if (!isWorthAsking(configuration)) {
    return orderByWaiting(waited, start_distances_);
  }
  const PolicySteps::Entry& entry = steps_->enter(configuration, before);
  visits_[&entry].waited = waited;
  return orderByWaiting(waited, selfishFirst(entry.step.social.svo_deg, waited, start_distances_));
}

bool PolicyGenerator::generate(const Vertices& from, const std::vector<AgentId>& order,
                               Vertices& to) {
  const PolicySteps::Entry* entry = steps_->find(from);
  const auto visit = visits_.find(entry);
  if (visit == visits_.end() || ++visit->second.steps > patience_.steps) {
    return pibt_.step(from, order, distance_ranking_, to);
  }
  policy_ranking_.listenTo(entry->step.actions, visit->second.waited);
  return pibt_.step(from, order, policy_ranking_, to);
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
