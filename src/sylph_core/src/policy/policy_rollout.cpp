#include "sylph_core/policy/policy_rollout.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "sylph_core/social/precedence.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

constexpr int kFewestAgentsOfThread = 16;  // for fewer, starting a thread costs more than it saves

/// Weights may be such that numbers overflow; then the network has said nothing.
void silenceUnlessFinite(AgentRows& logits) {
  for (Eigen::Index row = 0; row < logits.rows(); ++row) {
    if (!logits.row(row).allFinite()) {
      logits.row(row).setZero();
    }
  }
}

AgentRows softmax(const AgentRows& logits) {
  AgentRows probabilities = (logits.colwise() - logits.rowwise().maxCoeff()).array().exp();
  probabilities.array().colwise() /= probabilities.rowwise().sum().array().eval();
  return probabilities;
}

float meanAngle(const float* probabilities) {
  return static_cast<float>(
      meanSvo(std::vector<float>(probabilities, probabilities + kSvoLevelCount)));
}

float drawnAngle(const float* probabilities, Rng& rng) {
  const std::size_t level =
      drawByWeight(rng, kSvoLevelCount, [&](std::size_t index) { return probabilities[index]; });
  return static_cast<float>(svoOfLevel(static_cast<int>(level)));
}

float randomAngle(Rng& rng) {
  return static_cast<float>(svoOfLevel(static_cast<int>(drawIndex(rng, kSvoLevelCount))));
}

/// Whether the policy has no say in the SVO.
bool isAssigned(SvoChoice choice) {
  return choice != SvoChoice::Mean && choice != SvoChoice::Sample;
}

/// The distribution of an agent on its goal.
template <typename Row>
void makeMostProsocial(Row&& probabilities) {
  probabilities.setZero();
  probabilities(kMostProsocialLevel) = 1.F;
}

Configuration goalsOf(const std::vector<DistanceField>& distances) {
  Configuration goals;
  goals.reserve(distances.size());
  for (const DistanceField& distance : distances) {
    goals.push_back(distance.goal());
  }
  return goals;
}

}  // namespace

PolicyRollout::PolicyRollout(const Policy& policy, const Grid& grid,
                             const std::vector<DistanceField>& distances, SvoChoice svo_choice,
                             int threads, Rng& rng)
    : policy_(&policy),
      svo_choice_(svo_choice),
      threads_(std::clamp(static_cast<int>(distances.size()) / kFewestAgentsOfThread, 1, threads)),
      distances_(&distances),
      encoder_(grid, distances),
      partners_(
          grid,
          [&distances](AgentId agent, const Cell& cell) {
            return distances[static_cast<std::size_t>(agent)].at(cell);
          },
          goalsOf(distances)) {  // anywhere: follow() tells where the agents are
  for (std::size_t agent = 0; agent < distances.size(); ++agent) {
    tie_breaks_.push_back(static_cast<float>(drawFraction(rng)));
  }
  if (svo_choice == SvoChoice::RandomPerEpisode) {
    for (std::size_t agent = 0; agent < distances.size(); ++agent) {
      episode_svo_deg_.push_back(randomAngle(rng));
    }
  }
}

PolicyStep PolicyRollout::nothingKnown() const {
  const std::size_t count = distances_->size();
  PolicyStep step;
  step.priorities.assign(count, 0);
  step.svo.resize(static_cast<Eigen::Index>(count), kSvoLevelCount);
  for (std::size_t agent = 0; agent < count; ++agent) {
    step.social.svo_deg.push_back(svoByPriority(1, tie_breaks_[agent]));
    spreadOverLevels(step.social.svo_deg[agent],
                     step.svo.row(static_cast<Eigen::Index>(agent)).data());
  }
  step.social.partners.resize(count);
  std::iota(step.social.partners.begin(), step.social.partners.end(), 0);
  return step;
}

PolicyStep PolicyRollout::follow(const PolicyStep& before, const Configuration& from,
                                 const Configuration& to, Rng& rng, StepUse use) {
  const std::size_t count = distances_->size();
  const auto rows = static_cast<Eigen::Index>(count);
  if (from.size() != count || to.size() != count || before.svo.rows() != rows) {
    throw std::invalid_argument("a step of " + std::to_string(to.size()) + " agents: must be " +
                                std::to_string(count));
  }
  AgentStates states{to, {}, before.social.svo_deg, before.priorities, tie_breaks_};
  NetworkInput input;
  input.svo = before.svo;
  partners_.update(to, before.social.partners);
  input.partners = partners_.fixed();
  for (std::size_t agent = 0; agent < count; ++agent) {
    states.last_moves.push_back(actionBetween(from[agent], to[agent]).value_or(Action::Stay));
    const bool is_home = to[agent] == (*distances_)[agent].goal();
    states.priorities[agent] = is_home ? 0 : states.priorities[agent] + 1;
    auto svo = input.svo.row(static_cast<Eigen::Index>(agent));
    if (is_home) {
      states.svo_deg[agent] = static_cast<float>(svoOfLevel(kMostProsocialLevel));
      makeMostProsocial(svo);
    } else if (isAssigned(svo_choice_)) {
      states.svo_deg[agent] = assigned(agent, states.priorities[agent], before, rng);
      spreadOverLevels(states.svo_deg[agent], svo.data());
    }
  }
  input.memory = before.memory.size() > 0 ? before.memory
                                          : AgentRows::Zero(rows, policy_->network().shape().width);
  return evaluate(std::move(states), std::move(input), use, rng);
}

PolicyStep PolicyRollout::evaluate(AgentStates states, NetworkInput input, StepUse use, Rng& rng) {
  const std::size_t count = distances_->size();
  const auto rows = static_cast<Eigen::Index>(count);
  encoder_.setStates(states);
  input.views.resize(rows, kObservationSize);
  input.vectors.resize(rows, kVectorSize);
  for (Eigen::Index agent = 0; agent < rows; ++agent) {
    encoder_.encode(static_cast<AgentId>(agent), input.views.row(agent).data(),
                    input.vectors.row(agent).data());
  }
  NetworkOutput output = policy_->network().forward(input, threads_);
  ++calls_;
  PolicyStep step;
  step.by_cost = output.actions;
  step.actions = std::move(output.actions);
  if (policy_->costNetwork() != nullptr && use == StepUse::Search) {
    input.memory.setZero();
    step.by_cost = policy_->costNetwork()->forward(input, threads_).actions;
  }
  // A single number gone wrong must not take the whole team with it.
  silenceUnlessFinite(step.actions);
  silenceUnlessFinite(step.by_cost);
  silenceUnlessFinite(output.svo);
  step.svo = isAssigned(svo_choice_) ? std::move(input.svo) : softmax(output.svo);
  step.priorities = std::move(states.priorities);
  step.social.partners = std::move(input.partners);
  for (Eigen::Index agent = 0; agent < rows; ++agent) {
    const auto index = static_cast<std::size_t>(agent);
    if (states.cells[index] == (*distances_)[index].goal()) {
      makeMostProsocial(step.svo.row(agent));
    }
    step.social.svo_deg.push_back(actedBy(step.svo.row(agent).data(), rng));
  }
  if (policy_->hasMemory()) {
    step.memory = std::move(output.memory);
    silenceUnlessFinite(step.memory);
  }
  return step;
}

/// The SVO of an agent off its goal where the policy has no say [deg].
float PolicyRollout::assigned(std::size_t agent, int priority, const PolicyStep& before,
                              Rng& rng) const {
  const bool was_under_way = before.priorities[agent] > 0;  // neither on its goal nor at the start
  if (svo_choice_ == SvoChoice::Priority) {
    return svoByPriority(priority, tie_breaks_[agent]);
  }
  if (svo_choice_ == SvoChoice::RandomPerEpisode) {
    return episode_svo_deg_[agent];
  }
  if (svo_choice_ == SvoChoice::RandomPerPartner && was_under_way &&
      partners_.fixed()[agent] == before.social.partners[agent]) {
    return before.social.svo_deg[agent];
  }
  return randomAngle(rng);
}

float PolicyRollout::actedBy(const float* probabilities, Rng& rng) const {
  return svo_choice_ == SvoChoice::Sample ? drawnAngle(probabilities, rng)
                                          : meanAngle(probabilities);
}

}  // namespace sylph
