#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sylph_core/grid/rng.hpp"
#include "sylph_training/imitation/imitation_batch.hpp"
#include "sylph_training/imitation/reactive_scenes.hpp"
#include "sylph_training/model/learner.hpp"
#include "sylph_training/model/precision.hpp"
#include "sylph_training/run/phase.hpp"
#include "sylph_training/run/policy_meters.hpp"

namespace sylph_training {

/// How the policy learns from demonstrations.
struct ImitationSettings {
  long steps = 5000;              ///< > 0
  int batch = 1024;               ///< samples of a step, about, > 0
  int first_shards = 10;          ///< to begin with; more are taken in as they appear, > 0
  int refill_steps = 200;         ///< steps between looks for new shards, > 0
  int log_steps = 20;             ///< steps between lines of the log, > 0
  int validation_steps = 200;     ///< steps between validations, > 0
  int validation_samples = 8000;  ///< about, > 0
  Precision precision = Precision::Auto;
  double valid_weight = 0.0;  ///< of the valid actions' loss, >= 0; the paper has 0.5
  double svo_weight = 0.1;    ///< of the SVO head's loss, >= 0
  LabelSettings labels;
  LearnerSettings learner;
  std::optional<ReactiveSettings> reactive;  ///< without it all samples are demonstrations
  int meter_steps = 1000;                    ///< steps between looks at the meters, > 0
  std::optional<MeterSettings> meters;       ///< what is measured then, if anything

  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static ImitationSettings read(const sylph::YamlMap& yaml);
};

/// Loss and measures of a batch.
struct ImitationLoss {
  torch::Tensor total;         ///< what the gradient follows
  double told = 0.0;           ///< samples that tell the action head something
  double cross_entropy = 0.0;  ///< of the actions towards their labels
  double accuracy = 0.0;       ///< share of the labels' actions among the most likely ones
  double best = 0.0;           ///< share of most likely actions without regret
  double samples = 0.0;        ///< all of them
  double svo = 0.0;            ///< cross entropy of the SVO head towards the rule of priorities
};

/// He et al. 2024 trains by reinforcement learning alone; this is a warm start.
///
/// Actions: cross entropy towards the labels among the actions that they compare. The teacher tells
/// whether to come closer to the goal and how to give way if not, but not by which of several moves
/// to come closer: that is what the expert's regrets are for. To it is added, weighed,
/// binary cross entropy of the logits against the set of valid actions as in the paper. SVO: cross
/// entropy of the head towards the rule of priorities, see sylph::svoByPriority().
ImitationLoss imitationLoss(PolicyModel& model, const ImitationBatch& batch,
                            const ImitationSettings& settings);

/// Learning from demonstrations and from what a reactive teacher says of configurations to which it
/// or the policy itself has come.
class ImitationPhase : public Phase {
 public:
  /// @param state  must outlive this object
  ImitationPhase(const ImitationSettings& settings, RunState& state);

  void prepare() override;
  long steps() const override { return settings_.steps; }
  std::pair<std::string, double> workPerStep() const override {
    return {"samples", static_cast<double>(settings_.batch)};
  }
  std::optional<Figures> step(long step) override;
  void save(torch::serialize::OutputArchive& archive) const override;
  void load(torch::serialize::InputArchive& archive) override;
  std::map<std::string, std::string> notes() const override;

 private:
  /// The shards of a folder in memory.
  struct Source {
    std::string folder;
    std::deque<SceneStore> shards;
    void load(int count);
  };

  void prepareReactive();
  void addStudentShard();
  const SceneStore& drawShard();
  std::vector<Pick> drawBatch();
  void setEncoderType(torch::ScalarType type);
  ImitationLoss validate(const Source& source);
  void readMeters();

  ImitationSettings settings_;
  RunState* state_;
  Learner learner_;
  Source demonstrations_;
  Source teacher_led_;
  Source student_led_;
  Source validation_;
  sylph::Rng rng_;
  std::vector<double> sums_;  // of the figures since the last line of the log
  long summed_ = 0;
  ImitationLoss validated_;
  std::vector<double> metered_;  // as kMetered in the source file, of each kind of worlds
  torch::ScalarType encoder_type_ = torch::kFloat;
  long samples_seen_ = 0;
};

}  // namespace sylph_training
