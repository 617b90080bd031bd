#include "sylph_training/worlds/environment_batch.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "sylph_core/policy/observation.hpp"
#include "sylph_core/social/precedence.hpp"

namespace sylph_training {
namespace {

using SvoDistribution = EnvironmentBatch::SvoDistribution;

SvoDistribution certainly(int level) {
  SvoDistribution distribution{};
  distribution[static_cast<std::size_t>(level)] = 1.F;
  return distribution;
}

float meanDeg(const SvoDistribution& distribution) {
  return static_cast<float>(sylph::meanSvo({distribution.begin(), distribution.end()}));
}

int drawLevel(sylph::Rng& rng) {
  return static_cast<int>(sylph::drawIndex(rng, sylph::kSvoLevelCount));
}

}  // namespace

int drawFrom(const float* probabilities, int count, sylph::Rng& rng) {
  return static_cast<int>(
      sylph::drawByWeight(rng, static_cast<std::size_t>(count),
                          [=](std::size_t index) { return probabilities[index]; }));
}

EnvironmentBatch::EnvironmentBatch(WorldSource source, const EnvironmentOptions& environment,
                                   const SvoOptions& svo, int worlds, std::uint32_t seed)
    : source_(std::move(source)), environment_options_(environment), svo_options_(svo) {
  if (worlds < 1) {
    throw std::invalid_argument("worlds = " + std::to_string(worlds) + ": must be > 0");
  }
  environment_options_.partners = svo.mode != SvoMode::Off;
  environment_options_.prosocial_on_goal = svo.mode == SvoMode::Learned;
  worlds_.resize(static_cast<std::size_t>(worlds));
  // Each world draws by itself, so that what happens in one shifts no other.
  std::seed_seq seeds = {seed};
  std::vector<std::uint32_t> drawn(worlds_.size());
  seeds.generate(drawn.begin(), drawn.end());
  for (std::size_t index = 0; index < worlds_.size(); ++index) {
    worlds_[index].rng.seed(drawn[index]);
    start(worlds_[index]);
  }
  countRows();
}

// Tie breaks, and levels at the start where these are fed back, are any, so that agents in equal
// places need not do the same.
void EnvironmentBatch::start(World& world) {
  std::vector<float> mean_deg;
  std::vector<float> tie_breaks;
  do {
    const sylph::Instance instance = source_(world.rng);
    world.svo.clear();
    world.levels.clear();
    mean_deg.clear();
    tie_breaks.clear();
    for (int agent = 0; agent < instance.agentCount(); ++agent) {
      const int level = svo_options_.mode == SvoMode::Off ? 0 : drawLevel(world.rng);
      world.levels.push_back(level);
      tie_breaks.push_back(static_cast<float>(sylph::drawFraction(world.rng)));
      if (svo_options_.mode == SvoMode::Learned &&
          svo_options_.feedback == SvoFeedback::Distribution) {
        world.svo.emplace_back();
        sylph::spreadOverLevels(sylph::svoByPriority(1, tie_breaks.back()),
                                world.svo.back().data());
      } else {
        world.svo.push_back(certainly(level));
      }
      mean_deg.push_back(meanDeg(world.svo.back()));
    }
    world.environment =
        std::make_unique<Environment>(instance, environment_options_, mean_deg, tie_breaks);
    // A world that begins solved has no step to learn from.
  } while (world.environment->isSolved());
  showProsocialOnGoal(world);
  world.partners = world.environment->partners();
  world.record = {};
  world.record.agents = world.environment->instance().agentCount();
}

void EnvironmentBatch::showProsocialOnGoal(World& world) const {
  for (std::size_t agent = 0; agent < world.svo.size(); ++agent) {
    if (svo_options_.mode == SvoMode::Learned &&
        world.environment->isOnGoal(static_cast<sylph::AgentId>(agent))) {
      world.svo[agent] = certainly(sylph::kMostProsocialLevel);
    }
  }
}

void EnvironmentBatch::countRows() {
  first_rows_ = {0};
  for (const World& world : worlds_) {
    first_rows_.push_back(first_rows_.back() + world.environment->instance().agentCount());
  }
}

const Environment& EnvironmentBatch::world(int index) const {
  return *worlds_.at(static_cast<std::size_t>(index)).environment;
}

sylph::Rng& EnvironmentBatch::rngOfWorld(int index) {
  return worlds_.at(static_cast<std::size_t>(index)).rng;
}

PolicyInput EnvironmentBatch::observe() const {
  const std::int64_t rows = rowCount();
  PolicyInput input;
  torch::Tensor views = torch::empty(
      {rows, sylph::kFieldOfView, sylph::kFieldOfView, sylph::kChannelCount}, torch::kFloat);
  input.vectors = torch::empty({rows, sylph::kVectorSize}, torch::kFloat);
  input.svo = torch::empty({rows, sylph::kSvoLevelCount}, torch::kFloat);
  auto* view = views.data_ptr<float>();
  auto* vector = input.vectors.data_ptr<float>();
  auto* svo = input.svo.data_ptr<float>();
  for (const World& world : worlds_) {
    for (std::size_t agent = 0; agent < world.svo.size(); ++agent) {
      world.environment->encode(static_cast<sylph::AgentId>(agent), view, vector);
      svo = std::copy(world.svo[agent].begin(), world.svo[agent].end(), svo);
      view += sylph::kObservationSize;
      vector += sylph::kVectorSize;
    }
  }
  input.views = views.permute({0, 3, 1, 2});
  std::tie(input.hop1, input.hop2) = hopMatrices(partnerRows());
  return input;
}

std::vector<std::int64_t> EnvironmentBatch::partnerRows() const {
  std::vector<std::int64_t> rows;
  for (std::size_t index = 0; index < worlds_.size(); ++index) {
    for (const sylph::AgentId partner : worlds_[index].environment->partners()) {
      rows.push_back(first_rows_[index] + partner);
    }
  }
  return rows;
}

BatchStep EnvironmentBatch::step(const std::vector<sylph::Action>& desired,
                                 const torch::Tensor& svo_probabilities) {
  if (static_cast<std::int64_t>(desired.size()) != rowCount() ||
      svo_probabilities.sizes() != torch::IntArrayRef({rowCount(), sylph::kSvoLevelCount})) {
    throw std::invalid_argument("a step of " + std::to_string(desired.size()) +
                                " actions: must be " + std::to_string(rowCount()) +
                                ", with as many SVO distributions");
  }
  const torch::Tensor probabilities = svo_probabilities.to(torch::kFloat).contiguous();
  BatchStep step;
  for (std::size_t index = 0; index < worlds_.size(); ++index) {
    const std::int64_t row = first_rows_[index];
    stepWorld(static_cast<int>(index), desired.data() + row,
              probabilities.data_ptr<float>() + row * sylph::kSvoLevelCount, step);
  }
  return step;
}

void EnvironmentBatch::stepWorld(int index, const sylph::Action* desired,
                                 const float* svo_probabilities, BatchStep& step) {
  World& world = worlds_[static_cast<std::size_t>(index)];
  const std::size_t agents = world.svo.size();
  StepSvo svo;
  for (std::size_t agent = 0; agent < agents; ++agent) {
    chooseSvo(world, agent, svo_probabilities + agent * sylph::kSvoLevelCount, svo, step);
  }
  world.partners = world.environment->partners();
  const StepOutcome outcome = world.environment->step({desired, desired + agents}, svo);
  showProsocialOnGoal(world);
  EpisodeRecord& record = world.record;
  for (std::size_t agent = 0; agent < agents; ++agent) {
    step.external_rewards.push_back(static_cast<float>(outcome.external_rewards[agent]));
    step.social_rewards.push_back(static_cast<float>(outcome.social_rewards[agent]));
    step.action_rewards.push_back(static_cast<float>(outcome.action_rewards[agent]));
    step.is_penalized.push_back(outcome.is_penalized[agent]);
    record.external_reward += outcome.external_rewards[agent];
    record.collisions += outcome.is_penalized[agent] ? 1 : 0;
    // Who passes by blocks nobody for long.
    if (outcome.actions[agent] == sylph::Action::Stay) {
      record.blocked += world.environment->blockedCounts()[agent];
    }
  }
  step.is_finished.push_back(world.environment->isFinished() ? 1 : 0);
  step.is_solved.push_back(world.environment->isSolved() ? 1 : 0);
  if (world.environment->isFinished()) {
    record.world = index;
    record.steps = world.environment->stepCount();
    record.is_solved = world.environment->isSolved();
    record.arrived = world.environment->arrivedCount();
    records_.push_back(record);
  }
}

void EnvironmentBatch::chooseSvo(World& world, std::size_t agent, const float* probabilities,
                                 StepSvo& svo, BatchStep& step) const {
  const auto id = static_cast<sylph::AgentId>(agent);
  int& level = world.levels[agent];
  SvoDistribution distribution = certainly(level);
  bool has_choice = false;
  switch (svo_options_.mode) {
    case SvoMode::Learned:
      if (world.environment->isOnGoal(id)) {
        level = sylph::kMostProsocialLevel;
        distribution = certainly(level);
      } else {
        has_choice = true;
        level = drawFrom(probabilities, sylph::kSvoLevelCount, world.rng);
        distribution = certainly(level);
        if (svo_options_.feedback == SvoFeedback::Distribution) {
          std::copy(probabilities, probabilities + sylph::kSvoLevelCount, distribution.begin());
        }
      }
      break;
    case SvoMode::RandomPerStep:
      level = drawLevel(world.rng);
      distribution = certainly(level);
      break;
    case SvoMode::RandomPerPartner:
      if (world.environment->partners()[agent] != world.partners[agent]) {
        level = drawLevel(world.rng);
        distribution = certainly(level);
      }
      break;
    case SvoMode::Off:
    case SvoMode::RandomPerEpisode:
      break;
  }
  world.svo[agent] = distribution;
  svo.mean_deg.push_back(meanDeg(distribution));
  svo.drawn_deg.push_back(static_cast<float>(sylph::svoOfLevel(level)));
  step.svo_levels.push_back(level);
  step.svo.insert(step.svo.end(), distribution.begin(), distribution.end());
  step.has_svo_choice.push_back(has_choice ? 1.F : 0.F);
}

std::vector<std::int64_t> EnvironmentBatch::resetFinished() {
  const std::vector<std::int64_t> rows_before = first_rows_;
  std::vector<char> is_new(worlds_.size(), 0);
  for (std::size_t index = 0; index < worlds_.size(); ++index) {
    if (worlds_[index].environment->isFinished()) {
      start(worlds_[index]);
      is_new[index] = 1;
    }
  }
  countRows();
  std::vector<std::int64_t> carried;
  for (std::size_t index = 0; index < worlds_.size(); ++index) {
    for (std::int64_t row = first_rows_[index]; row < first_rows_[index + 1]; ++row) {
      carried.push_back(is_new[index] != 0 ? -1 : rows_before[index] + row - first_rows_[index]);
    }
  }
  return carried;
}

std::vector<EpisodeRecord> EnvironmentBatch::takeRecords() {
  return std::exchange(records_, {});
}

}  // namespace sylph_training
