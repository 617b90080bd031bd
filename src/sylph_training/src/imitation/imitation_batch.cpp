#include "sylph_training/imitation/imitation_batch.hpp"

#include <cmath>

#include "sylph_core/policy/observation.hpp"
#include "sylph_core/social/svo.hpp"

namespace sylph_training {
namespace {

using sylph::kActionCount;

constexpr double kOneHotShare = 0.5;
constexpr double kNarrowestSpread = 0.5;  // [levels]
constexpr double kWidestSpread = 6.0;

void fillSvo(int level, sylph::Rng& rng, float* out) {
  const bool is_one_hot = sylph::drawFraction(rng) < kOneHotShare;
  const double spread =
      kNarrowestSpread + (kWidestSpread - kNarrowestSpread) * sylph::drawFraction(rng);
  double sum = 0.0;
  for (int other = 0; other < sylph::kSvoLevelCount; ++other) {
    const double weight =
        is_one_hot ? (other == level ? 1.0 : 0.0) : std::exp(-std::abs(other - level) / spread);
    out[other] = static_cast<float>(weight);
    sum += weight;
  }
  for (int other = 0; other < sylph::kSvoLevelCount; ++other) {
    out[other] /= static_cast<float>(sum);
  }
}

void fillLabels(const Sample& sample, const Symmetry& symmetry, const LabelSettings& labels,
                std::int64_t row, ImitationBatch& batch) {
  float* target = batch.targets.data_ptr<float>() + row * kActionCount;
  float* best = batch.is_best.data_ptr<float>() + row * kActionCount;
  float* valid = batch.is_valid.data_ptr<float>() + row * kActionCount;
  double sum = 0.0;
  for (const sylph::Action action : sylph::kActions) {
    const int regret = sample.regrets[static_cast<std::size_t>(action)];
    const auto image = static_cast<std::size_t>(symmetry.apply(action));
    best[image] = regret == 0 ? 1.F : 0.F;
    valid[image] = regret == kImpossible ? 0.F : 1.F;
    const double weight =
        regret == kImpossible ? 0.0 : std::exp(-static_cast<double>(regret) / labels.regret_scale);
    target[image] = static_cast<float>(weight);
    sum += weight;
  }
  const auto expert =
      static_cast<std::size_t>(symmetry.apply(static_cast<sylph::Action>(sample.action)));
  for (std::size_t action = 0; action < kActionCount; ++action) {
    target[action] *= static_cast<float>((1.0 - labels.expert_share) / sum);
  }
  target[expert] += static_cast<float>(labels.expert_share);
  batch.actions.data_ptr<std::int64_t>()[row] = static_cast<std::int64_t>(expert);
  batch.yields.data_ptr<float>()[row] =
      sample.yielding == Yielding::Unknown ? -1.F : static_cast<float>(sample.yielding);
}

}  // namespace

ImitationBatch ImitationBatch::to(torch::Device device) const {
  ImitationBatch moved = *this;
  moved.input = input.to(device);
  for (torch::Tensor* tensor :
       {&moved.targets, &moved.actions, &moved.is_best, &moved.is_valid, &moved.yields}) {
    *tensor = tensor->to(device);
  }
  return moved;
}

ImitationBatch makeBatch(const std::vector<Pick>& picks, int width, const LabelSettings& labels,
                         sylph::Rng& rng) {
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
  batch.yields = torch::empty({samples});
  std::vector<std::int64_t> partners;
  partners.reserve(static_cast<std::size_t>(agents));
  float* view = views.data_ptr<float>();
  float* vector = batch.input.vectors.data_ptr<float>();
  float* svo = batch.input.svo.data_ptr<float>();
  std::int64_t row = 0;
  for (const Pick& pick : picks) {
    const Symmetry symmetry(pick.symmetry);
    const auto first_agent = static_cast<std::int64_t>(partners.size());
    for (const SceneAgent& agent : pick.store->agents(pick.scene)) {
      const auto image = symmetry.apply(agent.vector);
      vector = std::copy(image.begin(), image.end(), vector);
      fillSvo(agent.svo_level, rng, svo);
      svo += sylph::kSvoLevelCount;
      partners.push_back(first_agent + agent.partner);
    }
    for (const Sample& sample : pick.store->samples(pick.scene)) {
      unpackView(symmetry.apply(sample.view), view);
      view += sylph::kObservationSize;
      batch.input.asked.data_ptr<std::int64_t>()[row] = first_agent + sample.agent;
      fillLabels(sample, symmetry, labels, row, batch);
      ++row;
    }
  }
  std::tie(batch.input.hop1, batch.input.hop2) = hopMatrices(partners);
  return batch;
}

}  // namespace sylph_training
