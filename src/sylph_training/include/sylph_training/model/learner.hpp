#pragma once

#include <torch/torch.h>

#include <string>

#include "sylph_core/files/yaml_map.hpp"
#include "sylph_core/grid/rng.hpp"
#include "sylph_training/model/policy_model.hpp"

namespace sylph_training {

/// How weights follow the gradient.
struct LearnerSettings {
  double learning_rate = 2e-3;        ///< at its highest, > 0
  double final_learning_rate = 1e-5;  ///< at the last step, > 0
  int warmup_steps = 100;             ///< from 0 to the highest rate, >= 0
  double weight_decay = 0.01;         ///< >= 0
  double gradient_norm = 1.0;         ///< longer gradients are shortened to it, > 0
  double average_decay = 0.995;       ///< of the running average of the weights, 0 ... 1
  int average_every = 4;              ///< steps between its updates, > 0

  /// Reads the members that are given.
  /// @throws std::runtime_error with one line naming file, line, field and what is allowed
  static LearnerSettings read(const sylph::YamlMap& yaml);
};

/// AdamW with a cosine of the learning rate, and a running average of the weights.
class Learner {
 public:
  /// @param steps  that will be taken, for the learning rate
  /// @param model  of which what requires a gradient learns
  Learner(const LearnerSettings& settings, long steps, PolicyModel model, PolicyModel average);

  /// One step down the gradient of a loss.
  /// @return the norm of the gradient before it was shortened
  double step(long step, const torch::Tensor& loss);

  /// At a step, from 0.
  double learningRate(long step) const;

  /// The optimizer's state; the models' weights are saved by who owns them.
  void save(torch::serialize::OutputArchive& archive) const;
  /// Takes up what save() wrote.
  void load(torch::serialize::InputArchive& archive);

 private:
  LearnerSettings settings_;
  long steps_;
  PolicyModel model_;
  PolicyModel average_;
  torch::optim::AdamW optimizer_;
};

/// Copies weights from one model to another of the same shape.
void copyWeights(const PolicyModel& from, PolicyModel& to);

/// A generator's state in a checkpoint.
void save(torch::serialize::OutputArchive& archive, const std::string& key, const sylph::Rng& rng);
void load(torch::serialize::InputArchive& archive, const std::string& key, sylph::Rng& rng);

}  // namespace sylph_training
