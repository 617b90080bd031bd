#include "sylph_training/smp3o_phase.hpp"

#include <algorithm>

#include "sylph_core/search/deadline.hpp"
#include "sylph_training/learner.hpp"
#include "sylph_training/rollout.hpp"

namespace sylph_training {
namespace {

constexpr std::uint32_t kRngOffset = 991;  // a sequence of its own beside those of other phases

/// The model, with what the phase before would have exported.
PolicyModel& prepared(RunState& state, const Smp3oSettings& settings) {
  copyWeights(state.average, state.model);
  const auto type = settings.bfloat16 ? torch::kBFloat16 : torch::kFloat;
  state.model->setEncoderType(type);
  state.average->setEncoderType(type);
  return state.model;
}

}  // namespace

Smp3oPhase::Smp3oPhase(const Smp3oSettings& settings, RunState& state)
    : settings_(settings),
      state_(&state),
      learner_(prepared(state, settings), settings.learner, torch::kCPU),
      rng_(state.settings.seed + kRngOffset) {
  if (settings.imitation_rate > 0.0) {
    imitation_ = std::make_unique<ImitationPhase>(*settings.imitation, state);
  }
}

std::pair<std::string, double> Smp3oPhase::workPerStep() const {
  return {"agent steps", last_rows_};
}

WorldSource Smp3oPhase::worldSource() const {
  if (settings_.symmetric) {
    return [spec = *settings_.symmetric](sylph::Rng& rng) { return symmetricWorld(spec, rng); };
  }
  return [worlds = state_->settings.worlds](sylph::Rng& rng) { return sampleWorld(worlds, rng); };
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
  const sylph::Deadline clock(0.0);
  RolloutCollector collector(
      EnvironmentBatch(worldSource(), settings_.environment, settings_.svo, settings_.worlds, seed),
      settings_.memory, torch::kCPU);
  const Rollout rollout = collector.collect(learner_.model(), settings_.rollout_steps);
  const LearningStatistics learning = learner_.update(rollout, rng_);
  copyWeights(state_->model, state_->average);
  last_rows_ = static_cast<double>(rollout.rowCount());
  agent_steps_ += rollout.rowCount();
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
  return figures;
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
