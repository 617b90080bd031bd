#include "sylph_training/worlds/environment.hpp"

#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "sylph_core/social/svo.hpp"
#include "sylph_core/social/tie_breaking.hpp"
#include "sylph_training/worlds/collisions.hpp"

namespace sylph_training {
namespace {

using sylph::Action;
using sylph::AgentId;

sylph::Instance valid(sylph::Instance instance) {
  requireValid(instance);
  return instance;
}

EnvironmentOptions valid(const EnvironmentOptions& options) {
  options.requireValid();
  return options;
}

void requireCount(const char* what, std::size_t count, std::size_t expected) {
  if (count != expected) {
    throw std::invalid_argument(std::to_string(count) + " " + what + ": must be " +
                                std::to_string(expected) + ", one per agent");
  }
}

}  // namespace

void EnvironmentOptions::requireValid() const {
  if (max_steps < 1) {
    throw std::invalid_argument("max_steps = " + std::to_string(max_steps) + ": must be > 0");
  }
  if (!(rewards.svo_importance > 0.0)) {
    throw std::invalid_argument("svo_importance = " + std::to_string(rewards.svo_importance) +
                                ": must be > 0");
  }
}

Environment::Environment(sylph::Instance instance, const EnvironmentOptions& options,
                         std::vector<float> svo_deg, std::vector<float> tie_breaks)
    : instance_(valid(std::move(instance))),
      options_(valid(options)),
      distances_(sylph::distancesTo(instance_.goals, instance_.grid)),
      states_{instance_.starts, std::vector<Action>(instance_.starts.size(), Action::Stay),
              std::move(svo_deg), std::vector<int>(instance_.starts.size(), 0),
              std::move(tie_breaks)},
      encoder_(instance_.grid, distances_),
      partners_(
          instance_.grid,
          [this](AgentId agent, const sylph::Cell& cell) {
            return distances_[static_cast<std::size_t>(agent)].at(cell);
          },
          instance_.starts),
      partner_ids_(instance_.starts.size()),
      blocking_(instance_.grid, distances_, options_.rewards.blocking_detour_cells),
      blocked_(blocking_.count(states_.cells)) {
  requireCount("SVOs", states_.svo_deg.size(), states_.cells.size());
  if (states_.tie_breaks.empty()) {
    // A world by itself needs none; a batch draws them.
    states_.tie_breaks.assign(states_.cells.size(), 0.F);
  }
  requireCount("tie breaks", states_.tie_breaks.size(), states_.cells.size());
  updatePriorities();
  showSvo(states_.svo_deg);
  updatePartners();
}

void Environment::showSvo(const std::vector<float>& svo_deg) {
  states_.svo_deg = svo_deg;
  for (AgentId agent = 0; options_.prosocial_on_goal && agent < instance_.agentCount(); ++agent) {
    if (isOnGoal(agent)) {
      states_.svo_deg[static_cast<std::size_t>(agent)] =
          static_cast<float>(sylph::svoOfLevel(sylph::kMostProsocialLevel));
    }
  }
  encoder_.setStates(states_);
}

void Environment::updatePriorities() {
  for (AgentId agent = 0; agent < instance_.agentCount(); ++agent) {
    int& priority = states_.priorities[static_cast<std::size_t>(agent)];
    priority = isOnGoal(agent) ? 0 : priority + 1;
  }
}

void Environment::updatePartners() {
  if (options_.partners) {
    partner_ids_ = partners_.fixed();
  } else {
    std::iota(partner_ids_.begin(), partner_ids_.end(), 0);
  }
}

double Environment::partnerOverlap(AgentId agent) const {
  return partners_.overlap(agent, partner_ids_[static_cast<std::size_t>(agent)]);
}

bool Environment::isOnGoal(AgentId agent) const {
  const auto index = static_cast<std::size_t>(agent);
  return states_.cells[index] == instance_.goals[index];
}

int Environment::arrivedCount() const {
  int arrived = 0;
  for (AgentId agent = 0; agent < instance_.agentCount(); ++agent) {
    arrived += isOnGoal(agent) ? 1 : 0;
  }
  return arrived;
}

bool Environment::isValid(AgentId agent, Action action) const {
  return instance_.grid.isFree(neighbor(states_.cells[static_cast<std::size_t>(agent)], action));
}

void Environment::encode(AgentId agent, float* view, float* vector) const {
  encoder_.encode(agent, view, vector);
}

StepOutcome Environment::step(const std::vector<Action>& desired, const StepSvo& svo) {
  const std::size_t count = states_.cells.size();
  requireCount("actions", desired.size(), count);
  requireCount("SVOs", svo.mean_deg.size(), count);
  requireCount("drawn SVOs", svo.drawn_deg.size(), count);
  if (isFinished()) {
    throw std::logic_error("a step after the end of the episode");
  }
  sylph::TieBreaking resolved =
      options_.tie_breaking
          ? breakTies(instance_.grid, instance_.motion, states_.cells, desired, svo.mean_deg)
          : haltCollisions(instance_.grid, instance_.motion, states_.cells, desired);
  for (std::size_t agent = 0; agent < count; ++agent) {
    states_.cells[agent] = neighbor(states_.cells[agent], resolved.actions[agent]);
  }
  states_.last_moves = resolved.actions;
  updatePriorities();
  blocked_ = blocking_.count(states_.cells);
  ++step_count_;

  StepOutcome outcome;
  outcome.actions = std::move(resolved.actions);
  outcome.is_penalized = std::move(resolved.is_penalized);
  for (std::size_t agent = 0; agent < count; ++agent) {
    outcome.external_rewards.push_back(externalReward(agent, outcome));
  }
  shareRewards(svo.drawn_deg, outcome);
  partners_.update(states_.cells);
  updatePartners();
  showSvo(svo.mean_deg);
  return outcome;
}

double Environment::externalReward(std::size_t agent, const StepOutcome& outcome) const {
  const RewardOptions& rewards = options_.rewards;
  if (outcome.is_penalized[agent]) {
    return rewards.collision;
  }
  if (outcome.actions[agent] != Action::Stay) {
    return rewards.move;
  }
  // Who stands on its goal costs nothing unless it is in others' way.
  return isOnGoal(static_cast<AgentId>(agent))
             ? rewards.stay_on_goal + rewards.blocking * blocked_[agent]
             : rewards.stay_off_goal;
}

// With the partners of the state in which the agents decided.
void Environment::shareRewards(const std::vector<float>& drawn_svo_deg,
                               StepOutcome& outcome) const {
  for (std::size_t agent = 0; agent < outcome.external_rewards.size(); ++agent) {
    const double own = outcome.external_rewards[agent];
    const double partners = outcome.external_rewards[static_cast<std::size_t>(partner_ids_[agent])];
    outcome.social_rewards.push_back((own + partners) / options_.rewards.svo_importance);
    // cos + sin is 1 at 0 degrees and 1.4 at 45: without the mean a prosocial agent has larger
    // rewards, which are costs here, and learns to be selfish for that alone.
    const double scale = options_.rewards.mean_by_svo
                             ? sylph::redistributedReward(1.0, 1.0, drawn_svo_deg[agent])
                             : 1.0;
    outcome.action_rewards.push_back(
        sylph::redistributedReward(own, partners, drawn_svo_deg[agent]) / scale);
  }
}

}  // namespace sylph_training
