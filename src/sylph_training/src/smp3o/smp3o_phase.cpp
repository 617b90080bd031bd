#include "sylph_training/smp3o/smp3o_phase.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "sylph_core/search/deadline.hpp"
#include "sylph_training/model/learner.hpp"
#include "sylph_training/smp3o/rollout.hpp"

namespace sylph_training {
namespace {

constexpr std::uint32_t kRngOffset = 991;  // a sequence of its own beside those of other phases
constexpr std::uint32_t kValidationSeed = 1'000'000'007;
// Which figures of the episodes in worlds that the policy does not learn from are logged.
constexpr std::array<const char*, 4> kValidated = {"solved", "goals_reached", "episode_steps",
                                                   "external_reward"};

/// The model, with what the phase before would have exported.
PolicyModel& learningModel(RunState& state) {
  copyWeights(state.average, state.model);
  return state.model;
}

}  // namespace

Smp3oPhase::Smp3oPhase(const Smp3oSettings& settings, RunState& state)
    : settings_(settings),
      state_(&state),
      learner_(learningModel(state), settings.learner, state.settings.device),
      rng_(state.settings.seed + kRngOffset) {
  if (settings.imitation_rate > 0.0) {
    imitation_ = std::make_unique<ImitationPhase>(*settings.imitation, state);
  }
}

void Smp3oPhase::prepare() {
  const auto type = encoderType(settings_.precision, state_->model, state_->settings.device);
  state_->model->setEncoderType(type);
  state_->average->setEncoderType(type);
  if (imitation_) {
    imitation_->prepare();
  }
}

std::pair<std::string, double> Smp3oPhase::workPerStep() const {
  return {"agent steps", rows_per_step_};
}

WorldSource Smp3oPhase::worldSource() const {
  if (settings_.symmetric) {
    return [spec = *settings_.symmetric](sylph::Rng& rng) { return symmetricWorld(spec, rng); };
  }
  const WorldSettings worlds = settings_.worlds.value_or(state_->settings.worlds);
  return [worlds](sylph::Rng& rng) { return sampleWorld(worlds, rng); };
}

RolloutCollector Smp3oPhase::makeCollector(int environments, std::uint32_t seed) const {
  return {EnvironmentBatch(worldSource(), settings_.environment, settings_.svo, environments, seed),
          settings_.memory, state_->settings.device};
}

void Smp3oPhase::validate() {
  RolloutCollector collector = makeCollector(settings_.validation_environments, kValidationSeed);
  const Rollout rollout = collector.collect(learner_.model(), settings_.environment.max_steps);
  const Figures figures = sylph_training::figuresOf(firstEpisodes(rollout.episodes));
  validated_.clear();
  for (const char* name : kValidated) {
    validated_.push_back(std::find_if(figures.begin(), figures.end(), [&](const auto& figure) {
                           return figure.first == name;
                         })->second);
  }
}

// Worlds begin anew with each step, so that a checkpoint need not hold any of them.
std::optional<Figures> Smp3oPhase::step(long step) {
  const double lot = sylph::drawFraction(rng_);
  const std::uint32_t seed = rng_();
  const bool is_last = step + 1 == settings_.steps;  // the last one has figures for the log
  if (lot < settings_.imitation_rate && !is_last) {
    imitation_->step(imitation_steps_++ % imitation_->steps());
    return std::nullopt;
  }
  if (rollouts_++ % settings_.validation_rollouts == 0) {
    validate();
  }
  const sylph::Deadline clock(0.0);
  const Rollout rollout = makeCollector(settings_.environments, seed)
                              .collect(learner_.model(), settings_.rollout_steps);
  const LearningStatistics learning = learner_.update(rollout, rng_);
  copyWeights(state_->model, state_->average);
  agent_steps_ += rollout.rowCount();
  rows_per_step_ = static_cast<double>(agent_steps_) / static_cast<double>(step + 1);
  if (is_last) {
    validate();
  }
  return figuresOf(rollout, learning, clock.elapsed());
}

Figures Smp3oPhase::figuresOf(const Rollout& rollout, const LearningStatistics& learning,
                              double seconds) const {
  Figures figures = {{"agent_steps", static_cast<double>(agent_steps_)},
                     {"agent_steps_per_s", static_cast<double>(rollout.rowCount()) / seconds}};
  const Figures episodes = sylph_training::figuresOf(rollout.episodes);
  figures.insert(figures.end(), episodes.begin(), episodes.end());
  const Figures learned = {
      {"svo_deg",
       (rollout.svo_levels.to(torch::kDouble) * sylph::kSvoLevelSpacingDeg).mean().item<double>()},
      {"action_policy_loss", learning.action_policy},
      {"svo_policy_loss", learning.svo_policy},
      {"value_loss", learning.value},
      {"action_entropy", learning.action_entropy},
      {"svo_entropy", learning.svo_entropy},
      {"valid_loss", learning.valid},
      {"blocking_loss", learning.blocking},
      {"stability_loss", learning.stability},
      {"clipped_share", learning.clipped_share},
      {"divergence", learning.divergence},
      {"gradient_norm", learning.gradient_norm}};
  figures.insert(figures.end(), learned.begin(), learned.end());
  for (std::size_t index = 0; index < kValidated.size(); ++index) {
    figures.emplace_back(std::string("validation_") + kValidated[index], validated_[index]);
  }
  return figures;
}

std::vector<EpisodeRecord> firstEpisodes(const std::vector<EpisodeRecord>& episodes) {
  std::vector<EpisodeRecord> first;
  std::set<int> worlds;
  std::copy_if(episodes.begin(), episodes.end(), std::back_inserter(first),
               [&](const EpisodeRecord& episode) { return worlds.insert(episode.world).second; });
  return first;
}

Figures figuresOf(const std::vector<EpisodeRecord>& episodes) {
  EpisodeRecord sum;
  double solved = 0.0;
  for (const EpisodeRecord& episode : episodes) {
    sum.agents += episode.agents;
    sum.steps += episode.steps;
    sum.arrived += episode.arrived;
    sum.external_reward += episode.external_reward;
    sum.blocked += episode.blocked;
    sum.collisions += episode.collisions;
    solved += episode.is_solved ? 1.0 : 0.0;
  }
  const double count = std::max(1.0, static_cast<double>(episodes.size()));
  return {{"episodes", static_cast<double>(episodes.size())},
          {"solved", solved / count},
          {"goals_reached", sum.arrived / count},
          {"agents", sum.agents / count},
          {"episode_steps", sum.steps / count},
          {"external_reward", sum.external_reward / count},
          {"blocked", sum.blocked / count},
          {"collisions", sum.collisions / count}};
}

void Smp3oPhase::save(torch::serialize::OutputArchive& archive) const {
  torch::serialize::OutputArchive optimizer(archive.compilation_unit());
  learner_.optimizer().save(optimizer);
  archive.write("optimizer", optimizer);
  sylph_training::save(archive, "rng", rng_);
  archive.write("agent_steps", c10::IValue(static_cast<std::int64_t>(agent_steps_)));
  archive.write("imitation_steps", c10::IValue(static_cast<std::int64_t>(imitation_steps_)));
  archive.write("rollouts", c10::IValue(static_cast<std::int64_t>(rollouts_)));
  archive.write("validated", torch::tensor(validated_, torch::kDouble));
  if (imitation_) {
    torch::serialize::OutputArchive part(archive.compilation_unit());
    imitation_->save(part);
    archive.write("imitation", part);
  }
}

void Smp3oPhase::load(torch::serialize::InputArchive& archive) {
  torch::serialize::InputArchive part;
  archive.read("optimizer", part);
  learner_.optimizer().load(part);
  sylph_training::load(archive, "rng", rng_);
  c10::IValue value;
  archive.read("agent_steps", value);
  agent_steps_ = value.toInt();
  archive.read("imitation_steps", value);
  imitation_steps_ = value.toInt();
  archive.read("rollouts", value);
  rollouts_ = value.toInt();
  torch::Tensor validated;
  archive.read("validated", validated);
  validated = validated.to(torch::kCPU);
  validated_.assign(validated.data_ptr<double>(), validated.data_ptr<double>() + validated.numel());
  if (imitation_) {
    archive.read("imitation", part);
    imitation_->load(part);
  }
}

std::map<std::string, std::string> Smp3oPhase::notes() const {
  return {{"smp3o_agent_steps", std::to_string(agent_steps_)},
          {"memory", settings_.memory ? "true" : "false"}};
}

}  // namespace sylph_training
