#include "sylph_training/imitation/imitation_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "sylph_core/policy/observation.hpp"
#include "sylph_core/social/precedence.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph_training {
namespace {

using sylph::kActionCount;

constexpr float kFrom_centideg = 0.01F;

using Flags = std::array<bool, kActionCount>;

/// The moves that come closer to the goal.
Flags greedyMoves(const Sample& sample) {
  constexpr std::size_t kCentre = sylph::kViewCells / 2;
  Flags is_greedy{};
  for (std::size_t way = 0; way + 1 < kActionCount; ++way) {
    const auto bit = static_cast<std::size_t>(sylph::Channel::NearerNorth) + way;
    is_greedy[way + 1] = ((sample.view[kCentre] >> bit) & 1U) != 0;
  }
  return is_greedy;
}

Flags allMoves() {
  Flags all;
  all.fill(true);
  return all;
}

/// Which actions the label compares: all, or only those that come closer to the goal.
Flags compared(const Sample& sample) {
  return sample.only_ties != 0 ? greedyMoves(sample) : allMoves();
}

bool isVoted(const Sample& sample) {
  return std::any_of(sample.votes.begin(), sample.votes.end(),
                     [](std::uint8_t votes) { return votes > 0; });
}

using Label = std::array<double, kActionCount>;

/// The distribution to learn among the actions that are compared, in the order of Action.
Label labelOf(const Sample& sample, const Flags& is_compared, const LabelSettings& labels) {
  const double votes = std::accumulate(sample.votes.begin(), sample.votes.end(), 0.0);
  Label label{};
  double sum = 0.0;
  for (std::size_t action = 0; action < kActionCount; ++action) {
    const int regret = sample.regrets[action];
    if (votes > 0.0) {
      label[action] = sample.votes[action];
    } else if (regret != kImpossible && is_compared[action]) {
      label[action] = std::exp(-static_cast<double>(regret) / labels.regret_scale);
    }
    sum += label[action];
  }
  const bool has_expert = votes == 0.0 && is_compared[sample.action];
  const double rest = has_expert ? 1.0 - labels.expert_share : 1.0;
  for (double& weight : label) {
    weight *= sum > 0.0 ? rest / sum : 0.0;
  }
  if (has_expert) {
    label[sample.action] += labels.expert_share;
  }
  return label;
}

/// What the rule of priorities says of an agent.
float ruleOf(const SceneAgent& agent) {
  const auto entry = [&](sylph::VectorEntry which) {
    return agent.vector[static_cast<std::size_t>(which)];
  };
  const auto priority = static_cast<int>(std::lround(entry(sylph::VectorEntry::Priority) * 64.F));
  return sylph::svoByPriority(priority, entry(sylph::VectorEntry::TieBreak));
}

void fillLabels(const Sample& sample, const Symmetry& symmetry, const LabelSettings& labels,
                std::int64_t row, ImitationBatch& batch) {
  const auto rowOf = [&](torch::Tensor& tensor) {
    return tensor.data_ptr<float>() + row * static_cast<std::int64_t>(kActionCount);
  };
  const Flags is_compared = compared(sample);
  const Label label = labelOf(sample, is_compared, labels);
  const Flags is_greedy = isVoted(sample) ? greedyMoves(sample) : Flags{};
  for (const sylph::Action action : sylph::kActions) {
    const auto index = static_cast<std::size_t>(action);
    const auto image = static_cast<std::size_t>(symmetry.apply(action));
    rowOf(batch.targets)[image] = static_cast<float>(label[index]);
    rowOf(batch.is_compared)[image] = is_compared[index] ? 1.F : 0.F;
    rowOf(batch.is_alike)[image] = is_greedy[index] ? 1.F : 0.F;
    rowOf(batch.is_best)[image] = sample.regrets[index] == 0 ? 1.F : 0.F;
    rowOf(batch.is_valid)[image] = sample.regrets[index] == kImpossible ? 0.F : 1.F;
  }
  batch.actions.data_ptr<std::int64_t>()[row] =
      static_cast<std::int64_t>(symmetry.apply(static_cast<sylph::Action>(sample.action)));
}

}  // namespace

ImitationBatch ImitationBatch::to(torch::Device device) const {
  ImitationBatch moved = *this;
  moved.input = input.to(device);
  for (torch::Tensor* tensor : {&moved.targets, &moved.is_compared, &moved.is_alike, &moved.actions,
                                &moved.is_best, &moved.is_valid, &moved.svo_targets}) {
    *tensor = tensor->to(device);
  }
  return moved;
}

ImitationBatch makeBatch(const std::vector<Pick>& picks, int width, const LabelSettings& labels) {
  std::int64_t agents = 0;
  std::int64_t samples = 0;
  for (const Pick& pick : picks) {
    agents += static_cast<std::int64_t>(pick.store->agents(pick.scene).count);
    samples += static_cast<std::int64_t>(pick.store->samples(pick.scene).count);
  }
  ImitationBatch batch;
  const torch::Tensor views =
      torch::empty({samples, sylph::kFieldOfView, sylph::kFieldOfView, sylph::kChannelCount});
  batch.input.views = views.permute({0, 3, 1, 2});  // channels last in memory
  batch.input.vectors = torch::empty({agents, sylph::kVectorSize});
  batch.input.svo = torch::empty({agents, sylph::kSvoLevelCount});
  batch.input.memory = torch::zeros({samples, width});
  batch.input.asked = torch::empty({samples}, torch::kLong);
  batch.targets = torch::empty({samples, kActionCount});
  batch.actions = torch::empty({samples}, torch::kLong);
  batch.is_best = torch::empty({samples, kActionCount});
  batch.is_valid = torch::empty({samples, kActionCount});
  batch.is_compared = torch::empty({samples, kActionCount});
  batch.is_alike = torch::empty({samples, kActionCount});
  batch.svo_targets = torch::empty({samples, sylph::kSvoLevelCount});
  std::vector<std::int64_t> partners;
  partners.reserve(static_cast<std::size_t>(agents));
  auto* view = views.data_ptr<float>();
  auto* vector = batch.input.vectors.data_ptr<float>();
  auto* svo = batch.input.svo.data_ptr<float>();
  auto* target_svo = batch.svo_targets.data_ptr<float>();
  std::int64_t row = 0;
  for (const Pick& pick : picks) {
    const Symmetry symmetry(pick.symmetry);
    const auto first_agent = static_cast<std::int64_t>(partners.size());
    for (const SceneAgent& agent : pick.store->agents(pick.scene)) {
      const auto image = symmetry.apply(agent.vector);
      vector = std::copy(image.begin(), image.end(), vector);
      sylph::spreadOverLevels(kFrom_centideg * static_cast<float>(agent.svo_centideg), svo);
      svo += sylph::kSvoLevelCount;
      partners.push_back(first_agent + agent.partner);
    }
    for (const Sample& sample : pick.store->samples(pick.scene)) {
      unpackView(symmetry.apply(sample.view), view);
      view += sylph::kObservationSize;
      batch.input.asked.data_ptr<std::int64_t>()[row] = first_agent + sample.agent;
      fillLabels(sample, symmetry, labels, row, batch);
      sylph::spreadOverLevels(ruleOf(pick.store->agents(pick.scene)[sample.agent]), target_svo);
      target_svo += sylph::kSvoLevelCount;
      ++row;
    }
  }
  std::tie(batch.input.hop1, batch.input.hop2) = hopMatrices(partners);
  return batch;
}

}  // namespace sylph_training
