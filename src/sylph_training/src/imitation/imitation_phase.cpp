#include "sylph_training/imitation/imitation_phase.hpp"

#include <algorithm>
#include <stdexcept>

namespace sylph_training {
namespace {

constexpr std::uint32_t kRngOffset = 77;  // a sequence of its own beside that of the weights
constexpr std::uint32_t kCorrectionSeedOffset = 100'000'007;  // worlds of their own

int readCount(const sylph::YamlMap& yaml, const std::string& key, int otherwise) {
  return static_cast<int>(yaml.integer(key, otherwise, 1, 1000000000));
}

}  // namespace

ImitationSettings ImitationSettings::read(const sylph::YamlMap& yaml) {
  ImitationSettings settings;
  if (yaml.text("kind") == "dagger") {
    const auto corrections = yaml.map("corrections");
    settings.corrections =
        corrections ? CorrectionSettings::read(*corrections) : CorrectionSettings();
  }
  settings.steps = yaml.integer("steps", settings.steps, 1, 1000000000);
  settings.batch = readCount(yaml, "batch", settings.batch);
  settings.first_shards = readCount(yaml, "first_shards", settings.first_shards);
  settings.refill_steps = readCount(yaml, "refill_steps", settings.refill_steps);
  settings.log_steps = readCount(yaml, "log_steps", settings.log_steps);
  settings.validation_steps = readCount(yaml, "validation_steps", settings.validation_steps);
  settings.validation_samples = readCount(yaml, "validation_samples", settings.validation_samples);
  settings.bfloat16 = yaml.word("precision", {"bfloat16", "float"}, "bfloat16") == "bfloat16";
  settings.valid_weight =
      yaml.number("valid_weight", settings.valid_weight, sylph::Range::atLeast(0.0));
  settings.yielding_weight =
      yaml.number("yielding_weight", settings.yielding_weight, sylph::Range::atLeast(0.0));
  settings.labels.expert_share =
      yaml.number("expert_share", settings.labels.expert_share, {0.0, 1.0});
  settings.labels.regret_scale =
      yaml.number("regret_scale", settings.labels.regret_scale, sylph::Range::positive());
  settings.learner = LearnerSettings::read(yaml);
  yaml.refuseUnread();
  return settings;
}

void ImitationPhase::Source::load(int count) {
  while (static_cast<int>(shards.size()) < count) {
    const std::string path = shardPath(folder, static_cast<int>(shards.size()));
    shards.emplace_back().load(path);
  }
}

ImitationPhase::ImitationPhase(const ImitationSettings& settings, RunState& state)
    : settings_(settings),
      state_(&state),
      learner_(settings.learner, settings.steps, state.model, state.average),
      rng_(state.settings.seed + kRngOffset) {
  const auto type = settings.bfloat16 ? torch::kBFloat16 : torch::kFloat;
  state.model->setEncoderType(type);
  state.average->setEncoderType(type);
  const auto prepare = [](const ShardSettings& shards, int count, Source& source) {
    const SceneSource scenes = expertScenes(shards.demonstration);
    for (int shard = 0; shard < count; ++shard) {
      makeShard(shards, shard, scenes);
    }
    source.folder = shards.folder;
    source.load(count);
  };
  prepare(validationShards(state.settings, state.folder), state.settings.validation_shards,
          validation_);
  prepare(trainingShards(state.settings, state.folder), settings.first_shards, demonstrations_);
  if (settings.corrections) {
    makeCorrections();
  }
}

void ImitationPhase::makeCorrections() {
  const CorrectionSettings& settings = *settings_.corrections;
  ShardSettings shards = trainingShards(state_->settings, state_->folder);
  shards.worlds = settings.worlds_per_shard;
  const auto policy = std::make_shared<const sylph::Policy>(exportWeights(state_->average),
                                                            "the policy in training");
  const SceneSource scenes = correctedScenes(policy, settings, shards.demonstration);
  for (int round = 1; round <= settings.round; ++round) {
    shards.folder = state_->folder + "/corrections_" + std::to_string(round);
    shards.seed = state_->settings.seed + kCorrectionSeedOffset * static_cast<std::uint32_t>(round);
    for (int shard = 0; round == settings.round && shard < settings.shards; ++shard) {
      makeShard(shards, shard, scenes);
    }
    if (countShards(shards.folder) == 0) {
      throw std::runtime_error(shards.folder + ": has no shards: round " +
                               std::to_string(settings.round) + " needs those before it");
    }
    corrections_.emplace_back().folder = shards.folder;
    corrections_.back().load(countShards(shards.folder));
  }
}

const SceneStore& ImitationPhase::drawShard() {
  const Source* source = &demonstrations_;
  if (settings_.corrections && sylph::drawFraction(rng_) < settings_.corrections->share) {
    source = &corrections_[sylph::drawIndex(rng_, corrections_.size())];
  }
  return source->shards[sylph::drawIndex(rng_, source->shards.size())];
}

std::vector<Pick> ImitationPhase::drawBatch() {
  std::vector<Pick> picks;
  for (std::size_t samples = 0; samples < static_cast<std::size_t>(settings_.batch);) {
    const SceneStore& store = drawShard();
    const std::size_t scene = sylph::drawIndex(rng_, store.sceneCount());
    picks.push_back({&store, scene, static_cast<int>(sylph::drawIndex(rng_, Symmetry::kCount))});
    samples += store.samples(scene).count;
  }
  return picks;
}

std::optional<Figures> ImitationPhase::step(long step) {
  if (step == 0 && settings_.corrections) {
    copyWeights(state_->average, state_->model);  // it is the average that was corrected
  }
  if (step % settings_.refill_steps == 0) {
    demonstrations_.load(countShards(demonstrations_.folder));
  }
  const ImitationBatch batch =
      makeBatch(drawBatch(), state_->model->shape().width, settings_.labels, rng_)
          .to(state_->settings.device);
  const ImitationLoss loss = imitationLoss(state_->model, batch, settings_);
  const double norm = learner_.step(step, loss.total);
  samples_seen_ += batch.sampleCount();
  if ((step + 1) % settings_.validation_steps == 0 || step + 1 == settings_.steps) {
    validate();
  }
  const std::vector<double> measured = {loss.cross_entropy, loss.accuracy, loss.best, loss.yielding,
                                        norm};
  sums_.resize(measured.size(), 0.0);
  std::transform(measured.begin(), measured.end(), sums_.begin(), sums_.begin(), std::plus<>());
  ++summed_;
  if ((step + 1) % settings_.log_steps != 0 && step + 1 != settings_.steps) {
    return std::nullopt;
  }
  const auto mean = [&](std::size_t index) { return sums_[index] / static_cast<double>(summed_); };
  Figures figures = {{"samples", static_cast<double>(samples_seen_)},
                     {"shards", static_cast<double>(demonstrations_.shards.size())},
                     {"learning_rate", learner_.learningRate(step)},
                     {"cross_entropy", mean(0)},
                     {"accuracy", mean(1)},
                     {"best", mean(2)},
                     {"yielding", mean(3)},
                     {"gradient_norm", mean(4)},
                     {"validation_cross_entropy", validated_.cross_entropy},
                     {"validation_accuracy", validated_.accuracy},
                     {"validation_best", validated_.best},
                     {"validation_yielding", validated_.yielding}};
  sums_.clear();
  summed_ = 0;
  return figures;
}

void ImitationPhase::validate() {
  const torch::NoGradGuard no_grad;
  sylph::Rng rng(state_->settings.seed);
  ImitationLoss sum;
  int samples = 0;
  for (const SceneStore& store : validation_.shards) {
    const int wanted = settings_.validation_samples / static_cast<int>(validation_.shards.size());
    std::vector<Pick> picks;
    int drawn = 0;
    // Scenes of one world stand together: take some from all over the shard.
    const std::size_t stride = 1 + store.sampleCount() / static_cast<std::size_t>(wanted);
    for (std::size_t scene = 0; scene < store.sceneCount(); scene += stride) {
      picks.push_back({&store, scene, 0});
      drawn += static_cast<int>(store.samples(scene).count);
      if (picks.size() == 64 || scene + stride >= store.sceneCount()) {
        const ImitationBatch batch =
            makeBatch(picks, state_->model->shape().width, settings_.labels, rng)
                .to(state_->settings.device);
        const ImitationLoss loss = imitationLoss(state_->average, batch, settings_);
        sum.cross_entropy += loss.cross_entropy * drawn;
        sum.accuracy += loss.accuracy * drawn;
        sum.best += loss.best * drawn;
        sum.yielding += loss.yielding * drawn;
        samples += drawn;
        drawn = 0;
        picks.clear();
      }
    }
  }
  validated_ = {{},
                sum.cross_entropy / samples,
                sum.accuracy / samples,
                sum.best / samples,
                sum.yielding / samples};
}

void ImitationPhase::save(torch::serialize::OutputArchive& archive) const {
  learner_.save(archive);
  sylph_training::save(archive, "rng", rng_);
  archive.write("shards", c10::IValue(static_cast<std::int64_t>(demonstrations_.shards.size())));
  archive.write("samples_seen", c10::IValue(static_cast<std::int64_t>(samples_seen_)));
  archive.write("validated", torch::tensor({validated_.cross_entropy, validated_.accuracy,
                                            validated_.best, validated_.yielding},
                                           torch::kDouble));
}

void ImitationPhase::load(torch::serialize::InputArchive& archive) {
  learner_.load(archive);
  sylph_training::load(archive, "rng", rng_);
  c10::IValue value;
  archive.read("shards", value);
  demonstrations_.shards.clear();
  demonstrations_.load(static_cast<int>(value.toInt()));
  archive.read("samples_seen", value);
  samples_seen_ = value.toInt();
  torch::Tensor validated;
  archive.read("validated", validated);
  validated = validated.to(torch::kCPU);
  const double* figures = validated.data_ptr<double>();
  validated_ = {{}, figures[0], figures[1], figures[2], figures[3]};
}

std::map<std::string, std::string> ImitationPhase::notes() const {
  return {{"imitation_samples", std::to_string(samples_seen_)},
          {"validation_best", std::to_string(validated_.best)},
          {"memory", "false"}};
}

}  // namespace sylph_training
