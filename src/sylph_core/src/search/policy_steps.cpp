#include "sylph_core/search/policy_steps.hpp"

#include <utility>

namespace sylph {

PolicySteps::PolicySteps(PolicyRollout& rollout, const Graph& graph, Rng& rng)
    : rollout_(&rollout), graph_(&graph), rng_(&rng) {}

std::size_t PolicySteps::Hash::operator()(const Vertices& configuration) const {
  return hashOf(configuration);
}

const PolicySteps::Entry& PolicySteps::enter(const Vertices& configuration, const Vertices* before,
                                             StepUse use) {
  const Configuration to = graph_->toCells(configuration);
  const Configuration from = before == nullptr ? to : graph_->toCells(*before);
  // The search comes back to configurations by other ways: the last way there is taken for the
  // history.
  const Entry* known = before == nullptr ? nullptr : find(*before);
  PolicyStep step = rollout_->follow(known == nullptr ? rollout_->nothingKnown() : known->step,
                                     from, to, *rng_, use);
  entries_.push_back({configuration, known, std::move(step)});
  last_[configuration] = &entries_.back();
  return entries_.back();
}

const PolicySteps::Entry* PolicySteps::find(const Vertices& configuration) const {
  const auto found = last_.find(configuration);
  return found == last_.end() ? nullptr : found->second;
}

std::vector<const PolicySteps::Entry*> PolicySteps::entriesAlong(
    const std::vector<Vertices>& plan) const {
  std::vector<const Entry*> entries(plan.size() - 1);
  const Entry* entry = entries.empty() ? nullptr : find(plan[entries.size() - 1]);
  for (std::size_t timestep = entries.size(); timestep > 0; --timestep) {
    if (entry == nullptr || entry->configuration != plan[timestep - 1]) {
      return {};
    }
    entries[timestep - 1] = entry;
    entry = entry->before;
  }
  return entry == nullptr ? entries : std::vector<const Entry*>();
}

std::vector<SocialState> PolicySteps::along(const std::vector<Vertices>& plan,
                                            const Deadline& deadline) {
  std::vector<const Entry*> entries = entriesAlong(plan);
  for (std::size_t timestep = entries.size(); timestep + 1 < plan.size() && !deadline.isOver();
       ++timestep) {
    const Entry* before = timestep == 0 ? nullptr : entries.back();
    const Entry* known = find(plan[timestep]);
    entries.push_back(known != nullptr && known->before == before
                          ? known
                          : &enter(plan[timestep], timestep == 0 ? nullptr : &plan[timestep - 1],
                                   StepUse::Social));
  }
  std::vector<SocialState> states;
  states.reserve(entries.size());
  for (const Entry* entry : entries) {
    states.push_back(entry->step.social);
  }
  return states;
}

}  // namespace sylph
