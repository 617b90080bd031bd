#pragma once

#include <torch/torch.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sylph_training/model/policy_model.hpp"
#include "sylph_training/run/training_settings.hpp"

namespace sylph_training {

/// What the phases of a run share and hand on to each other.
struct RunState {
  TrainingSettings settings;  ///< of the whole run
  std::string folder;         ///< of the run
  PolicyModel model;          ///< learns
  PolicyModel average;        ///< running average of its weights: what is exported
};

/// Figures of some steps, for the log and the progress lines. A phase always names the same ones in
/// the same order.
using Figures = std::vector<std::pair<std::string, double>>;

/// A part of a training run with its own kind of learning.
class Phase {
 public:
  virtual ~Phase() = default;

  /// Makes what its steps need, such as scenes, which may take minutes. Called once, before load()
  /// and the first step.
  virtual void prepare() {}

  /// How many steps it takes in all.
  virtual long steps() const = 0;
  /// What a step's count is called and how many of them it handles, such as samples.
  virtual std::pair<std::string, double> workPerStep() const = 0;

  /// Takes one step.
  /// @param step  from 0 to steps() - 1
  /// @return now and then, what to write into the log
  virtual std::optional<Figures> step(long step) = 0;

  /// All that the next step depends on besides the two models, so that a phase which has loaded it
  /// goes on as the one that saved it, bit for bit. Called only right after a step that had
  /// something for the log.
  virtual void save(torch::serialize::OutputArchive& archive) const = 0;
  /// Takes up what save() wrote.
  virtual void load(torch::serialize::InputArchive& archive) = 0;

  /// Entries for the metadata of the weights.
  virtual std::map<std::string, std::string> notes() const = 0;
};

/// The phase that an entry of `phases` in the configuration describes.
/// @param state  must outlive the result
/// @throws std::runtime_error with one line naming file, line, field and what is allowed
std::unique_ptr<Phase> makePhase(const sylph::YamlMap& yaml, RunState& state);

}  // namespace sylph_training
