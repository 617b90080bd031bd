#include "sylph_training/imitation/imitation_phase.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

namespace sylph_training {
namespace {

constexpr std::uint32_t kRngOffset = 77;  // a sequence of its own beside that of the weights
// Worlds of their own.
constexpr std::uint32_t kTeacherSeedOffset = 100'000'007;
constexpr std::uint32_t kStudentSeedOffset = 200'000'033;

// Which figures of the meters are logged.
constexpr std::array<const char*, 8> kMetered = {"solved",     "cost_ratio",     "recall",
                                                 "precision",  "away_recall",    "away_precision",
                                                 "role_flips", "svo_sensitivity"};

int readCount(const sylph::YamlMap& yaml, const std::string& key, int otherwise) {
  return static_cast<int>(yaml.integer(key, otherwise, 1, 1000000000));
}

/// Adds a batch's measures, each times the samples that it is of.
void addWeighed(const ImitationLoss& batch, ImitationLoss& sum) {
  sum.told += batch.told;
  sum.cross_entropy += batch.told * batch.cross_entropy;
  sum.accuracy += batch.told * batch.accuracy;
  sum.best += batch.told * batch.best;
  sum.samples += batch.samples;
  sum.svo += batch.samples * batch.svo;
}

ImitationLoss meansOf(ImitationLoss sum) {
  const double told = std::max(1.0, sum.told);
  const double samples = std::max(1.0, sum.samples);
  sum.cross_entropy /= told;
  sum.accuracy /= told;
  sum.best /= told;
  sum.svo /= samples;
  return sum;
}

}  // namespace

ImitationSettings ImitationSettings::read(const sylph::YamlMap& yaml) {
  ImitationSettings settings;
  yaml.word("kind", {"imitation"}, yaml.text("kind"));
  if (const auto reactive = yaml.map("reactive")) {
    settings.reactive = ReactiveSettings::read(*reactive);
  }
  settings.steps = yaml.integer("steps", settings.steps, 1, 1000000000);
  settings.batch = readCount(yaml, "batch", settings.batch);
  settings.first_shards = readCount(yaml, "first_shards", settings.first_shards);
  settings.refill_steps = readCount(yaml, "refill_steps", settings.refill_steps);
  settings.log_steps = readCount(yaml, "log_steps", settings.log_steps);
  settings.validation_steps = readCount(yaml, "validation_steps", settings.validation_steps);
  settings.validation_samples = readCount(yaml, "validation_samples", settings.validation_samples);
  settings.precision = readPrecision(yaml);
  settings.meter_steps = readCount(yaml, "meter_steps", settings.meter_steps);
  if (const auto meters = yaml.map("meters")) {
    settings.meters = MeterSettings::read(*meters);
  }
  settings.valid_weight =
      yaml.number("valid_weight", settings.valid_weight, sylph::Range::atLeast(0.0));
  settings.svo_weight = yaml.number("svo_weight", settings.svo_weight, sylph::Range::atLeast(0.0));
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
  if (settings.meters) {
    metered_.assign(meterWorlds().size() * kMetered.size(), 0.0);
  }
}

void ImitationPhase::prepare() {
  setEncoderType(encoderType(settings_.precision, state_->model, state_->settings.device));
  const auto fill = [](const ShardSettings& shards, int count, Source& source) {
    const SceneSource scenes = expertScenes(shards.demonstration);
    for (int shard = 0; shard < count; ++shard) {
      makeShard(shards, shard, scenes);
    }
    source.folder = shards.folder;
    source.load(count);
  };
  const bool has_demonstrations = !settings_.reactive || settings_.reactive->share < 1.0;
  if (settings_.reactive) {
    prepareReactive();
  }
  if (has_demonstrations) {
    if (!settings_.reactive) {
      fill(validationShards(state_->settings, state_->folder), state_->settings.validation_shards,
           validation_);
    }
    fill(trainingShards(state_->settings, state_->folder), settings_.first_shards, demonstrations_);
  }
}

void ImitationPhase::setEncoderType(torch::ScalarType type) {
  encoder_type_ = type;
  state_->model->setEncoderType(type);
  state_->average->setEncoderType(type);
}

// Validation is by what the teacher says where it leads; what counts, where the policy leads, the
// meters tell.
void ImitationPhase::prepareReactive() {
  const ReactiveSettings& settings = *settings_.reactive;
  const SceneSource scenes = teacherLedScenes(settings);
  const auto prepare = [&](ShardSettings shards, const std::string& folder, std::uint32_t offset,
                           int count, Source& source) {
    shards.folder = state_->folder + "/" + folder;
    shards.seed += offset;
    shards.worlds = settings.worlds_per_shard;
    for (int shard = 0; shard < count; ++shard) {
      makeShard(shards, shard, scenes);
    }
    source.folder = shards.folder;
    source.load(count);
  };
  prepare(validationShards(state_->settings, state_->folder), "validation_teacher_led",
          kTeacherSeedOffset, state_->settings.validation_shards, validation_);
  prepare(trainingShards(state_->settings, state_->folder), "teacher_led", kTeacherSeedOffset,
          settings.teacher_shards, teacher_led_);
  student_led_.folder = state_->folder + "/student_led";
}

// Shards that a run which was killed has left behind after its checkpoint are made anew: they are
// of the same weights.
void ImitationPhase::addStudentShard() {
  ShardSettings shards = trainingShards(state_->settings, state_->folder);
  shards.folder = student_led_.folder;
  shards.seed += kStudentSeedOffset;
  shards.worlds = settings_.reactive->worlds_per_shard;
  const auto policy = std::make_shared<const sylph::Policy>(exportWeights(state_->average),
                                                            "the policy in training");
  const auto index = static_cast<int>(student_led_.shards.size());
  std::filesystem::remove(shardPath(shards.folder, index));
  makeShard(shards, index, studentLedScenes(policy, *settings_.reactive));
  student_led_.load(index + 1);
}

const SceneStore& ImitationPhase::drawShard() {
  const Source* source = &demonstrations_;
  if (settings_.reactive && sylph::drawFraction(rng_) < settings_.reactive->share) {
    const bool is_student = !student_led_.shards.empty() &&
                            sylph::drawFraction(rng_) < settings_.reactive->student_share;
    source = is_student ? &student_led_ : &teacher_led_;
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
  if (step % settings_.refill_steps == 0 && !demonstrations_.folder.empty()) {
    // Other programs may add shards while this one learns.
    demonstrations_.load(countShards(demonstrations_.folder));
  }
  if (settings_.reactive && step > 0 && step % settings_.reactive->student_steps == 0) {
    addStudentShard();
  }
  const ImitationBatch batch =
      makeBatch(drawBatch(), state_->model->shape().width, settings_.labels)
          .to(state_->settings.device);
  const ImitationLoss loss = imitationLoss(state_->model, batch, settings_);
  const double norm = learner_.step(step, loss.total);
  samples_seen_ += batch.sampleCount();
  if ((step + 1) % settings_.validation_steps == 0 || step + 1 == settings_.steps) {
    validated_ = validate(validation_);
  }
  if (settings_.meters &&
      ((step + 1) % settings_.meter_steps == 0 || step + 1 == settings_.steps)) {
    readMeters();
  }
  const std::vector<double> measured = {loss.cross_entropy, loss.accuracy, loss.best, loss.svo,
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
                     {"svo", mean(3)},
                     {"gradient_norm", mean(4)},
                     {"validation_cross_entropy", validated_.cross_entropy},
                     {"validation_accuracy", validated_.accuracy},
                     {"validation_best", validated_.best},
                     {"validation_svo", validated_.svo}};
  for (std::size_t index = 0; index < metered_.size(); ++index) {
    figures.emplace_back("meter_" + meterWorlds()[index / kMetered.size()].name() + "_" +
                             kMetered[index % kMetered.size()],
                         metered_[index]);
  }
  sums_.clear();
  summed_ = 0;
  return figures;
}

void ImitationPhase::readMeters() {
  // The average, since that is what is exported in the end.
  const sylph::Policy policy(exportWeights(state_->average), "the policy in training");
  metered_.clear();
  for (const MeterWorlds& worlds : meterWorlds()) {
    const Figures figures = measure(policy, worlds, *settings_.meters).figures();
    for (const char* name : kMetered) {
      metered_.push_back(std::find_if(figures.begin(), figures.end(), [&](const auto& figure) {
                           return figure.first == name;
                         })->second);
    }
  }
}

ImitationLoss ImitationPhase::validate(const Source& source) {
  const torch::NoGradGuard no_grad;
  ImitationLoss sum;
  const int wanted = settings_.validation_samples / static_cast<int>(source.shards.size());
  for (const SceneStore& store : source.shards) {
    std::vector<Pick> picks;
    // Scenes of one world stand together: take some from all over the shard.
    const std::size_t stride = 1 + store.sampleCount() / static_cast<std::size_t>(wanted);
    for (std::size_t scene = 0; scene < store.sceneCount(); scene += stride) {
      picks.push_back({&store, scene, 0});
      if (picks.size() == 64 || scene + stride >= store.sceneCount()) {
        const ImitationBatch batch =
            makeBatch(picks, state_->model->shape().width, settings_.labels)
                .to(state_->settings.device);
        addWeighed(imitationLoss(state_->average, batch, settings_), sum);
        picks.clear();
      }
    }
  }
  return meansOf(sum);
}

void ImitationPhase::save(torch::serialize::OutputArchive& archive) const {
  learner_.save(archive);
  sylph_training::save(archive, "rng", rng_);
  archive.write("shards", c10::IValue(static_cast<std::int64_t>(demonstrations_.shards.size())));
  archive.write("student_led", c10::IValue(static_cast<std::int64_t>(student_led_.shards.size())));
  archive.write("samples_seen", c10::IValue(static_cast<std::int64_t>(samples_seen_)));
  archive.write("bfloat16", c10::IValue(encoder_type_ == torch::kBFloat16));
  archive.write("metered", torch::tensor(metered_, torch::kDouble));
  archive.write("validated", torch::tensor({validated_.cross_entropy, validated_.accuracy,
                                            validated_.best, validated_.svo},
                                           torch::kDouble));
}

void ImitationPhase::load(torch::serialize::InputArchive& archive) {
  learner_.load(archive);
  sylph_training::load(archive, "rng", rng_);
  c10::IValue value;
  archive.read("shards", value);
  demonstrations_.shards.clear();
  demonstrations_.load(static_cast<int>(value.toInt()));
  archive.read("student_led", value);
  const auto student_led = static_cast<int>(value.toInt());
  student_led_.shards.clear();
  student_led_.load(std::min(student_led, countShards(student_led_.folder)));
  while (static_cast<int>(student_led_.shards.size()) < student_led) {
    addStudentShard();  // of a checkpoint that came without its folder
  }
  archive.read("samples_seen", value);
  samples_seen_ = value.toInt();
  archive.read("bfloat16", value);
  setEncoderType(value.toBool() ? torch::kBFloat16 : torch::kFloat);
  torch::Tensor metered;
  archive.read("metered", metered);
  metered = metered.to(torch::kCPU);
  metered_.assign(metered.data_ptr<double>(), metered.data_ptr<double>() + metered.numel());
  torch::Tensor validated;
  archive.read("validated", validated);
  constexpr std::int64_t kValidated = 4;
  if (validated.numel() < kValidated) {  // trainers of before had more
    throw std::runtime_error("the checkpoint is of another version of the trainer: its phase has " +
                             std::to_string(validated.numel()) + " figures of validation, not " +
                             std::to_string(kValidated));
  }
  validated = validated.to(torch::kCPU);
  const double* figures = validated.data_ptr<double>();
  validated_ = ImitationLoss();
  validated_.cross_entropy = figures[0];
  validated_.accuracy = figures[1];
  validated_.best = figures[2];
  validated_.svo = figures[3];
}

std::map<std::string, std::string> ImitationPhase::notes() const {
  return {{"imitation_samples", std::to_string(samples_seen_)},
          {"validation_best", std::to_string(validated_.best)},
          {"precision", nameOf(encoder_type_)},
          {"memory", "false"}};
}

}  // namespace sylph_training
