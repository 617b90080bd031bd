#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_training/imitation/imitation_phase.hpp"
#include "sylph_training/model/precision.hpp"
#include "sylph_training/run/phase.hpp"
#include "sylph_training/smp3o/rollout.hpp"
#include "sylph_training/smp3o/smp3o_learner.hpp"
#include "sylph_training/worlds/environment_batch.hpp"
#include "sylph_training/worlds/symmetric_worlds.hpp"

namespace sylph_training {

/// How the policy learns by reinforcement.
struct Smp3oSettings {
  /// Rollouts and, in between, steps of imitation, > 0. The default makes the paper's 2e7 agent
  /// steps if none is of imitation ...
  long steps = 488;
  int environments = 16;    ///< ... with 16 worlds side by side, > 0 ...
  int rollout_steps = 256;  ///< ... for 256 steps, > 0, of about 10 agents
  bool memory = true;       ///< feed the network's memory back from step to step
  Precision precision = Precision::Auto;
  std::optional<WorldSettings> worlds;          ///< instead of the run's
  std::optional<SymmetricWorldSpec> symmetric;  ///< worlds of the case study instead
  int validation_rollouts = 10;                 ///< rollouts between evaluations, > 0, on ...
  int validation_environments = 24;             ///< ... so many worlds, > 0, always the same
  double imitation_rate = 0.0;                  ///< chance of a step of imitation instead, 0 ... 1
  std::optional<ImitationSettings> imitation;   ///< settings of those steps
  EnvironmentOptions environment;
  SvoOptions svo;
  Smp3oLearnerOptions learner;

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static Smp3oSettings read(const sylph::YamlMap& yaml);
};

/// Learning by SMP3O. A step is a rollout, in worlds that all begin anew, and some epochs over it,
/// or now and then one of imitation.
class Smp3oPhase : public Phase {
 public:
  Smp3oPhase(const Smp3oSettings& settings, RunState& state);

  void prepare() override;
  long steps() const override { return settings_.steps; }
  std::pair<std::string, double> workPerStep() const override;
  std::optional<Figures> step(long step) override;
  void save(torch::serialize::OutputArchive& archive) const override;
  void load(torch::serialize::InputArchive& archive) override;
  std::map<std::string, std::string> notes() const override;

 private:
  WorldSource worldSource() const;
  RolloutCollector makeCollector(int environments, std::uint32_t seed) const;
  void validate();
  Figures figuresOf(const Rollout& rollout, const LearningStatistics& learning,
                    double seconds) const;

  Smp3oSettings settings_;
  RunState* state_;
  Smp3oLearner learner_;
  std::unique_ptr<Phase> imitation_;
  sylph::Rng rng_;
  std::vector<double> validated_;  // as kValidated in the source file
  long rollouts_ = 0;
  long imitation_steps_ = 0;
  long agent_steps_ = 0;
  double rows_per_step_ = 0.0;  // steps of imitation count too
};

/// The first episode of each world, where it ended: of those that follow there are the more, the
/// shorter they are.
std::vector<EpisodeRecord> firstEpisodes(const std::vector<EpisodeRecord>& episodes);

/// What is measured of a rollout's episodes, each a mean over the episodes that ended.
Figures figuresOf(const std::vector<EpisodeRecord>& episodes);

}  // namespace sylph_training
