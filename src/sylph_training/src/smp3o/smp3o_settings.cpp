#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "sylph_training/smp3o/smp3o_phase.hpp"

namespace sylph_training {
namespace {

using sylph::Range;
using sylph::YamlMap;

const std::map<std::string, SvoMode>& svoModes() {
  static const std::map<std::string, SvoMode> modes = {
      {"learned", SvoMode::Learned},
      {"off", SvoMode::Off},
      {"random_per_step", SvoMode::RandomPerStep},
      {"random_per_partner", SvoMode::RandomPerPartner},
      {"random_per_episode", SvoMode::RandomPerEpisode}};
  return modes;
}

void readNumber(const YamlMap& yaml, const std::string& key, const Range& range, double& value) {
  value = yaml.number(key, value, range);
}

void readCount(const YamlMap& yaml, const std::string& key, int& value) {
  value = static_cast<int>(yaml.integer(key, value, 1, 1000000000));
}

RewardOptions readRewards(const YamlMap& yaml) {
  RewardOptions rewards;
  readNumber(yaml, "move", {}, rewards.move);
  readNumber(yaml, "stay_off_goal", {}, rewards.stay_off_goal);
  readNumber(yaml, "stay_on_goal", {}, rewards.stay_on_goal);
  readNumber(yaml, "collision", {}, rewards.collision);
  readNumber(yaml, "blocking", {}, rewards.blocking);
  rewards.blocking_detour_cells = static_cast<int>(
      yaml.integer("blocking_detour_cells", rewards.blocking_detour_cells, 0, 1000000));
  rewards.mean_by_svo = yaml.boolean("mean_by_svo", rewards.mean_by_svo);
  readNumber(yaml, "svo_importance", Range::positive(), rewards.svo_importance);
  yaml.refuseUnread();
  return rewards;
}

LossWeights readWeights(const YamlMap& yaml) {
  LossWeights weights;
  const Range weight = Range::atLeast(0.0);
  readNumber(yaml, "policy", weight, weights.policy);
  readNumber(yaml, "value", weight, weights.value);
  readNumber(yaml, "entropy", weight, weights.entropy);
  readNumber(yaml, "valid", weight, weights.valid);
  readNumber(yaml, "blocking", weight, weights.blocking);
  readNumber(yaml, "stability", weight, weights.stability);
  yaml.refuseUnread();
  return weights;
}

SymmetricWorldSpec readSymmetric(const YamlMap& yaml) {
  SymmetricWorldSpec spec;
  readNumber(yaml, "recess_share", {0.0, 1.0}, spec.recess_share);
  readCount(yaml, "min_length", spec.min_length);
  readCount(yaml, "max_length", spec.max_length);
  try {
    spec.requireValid();
  } catch (const std::invalid_argument& error) {
    throw yaml.error("min_length", error.what());
  }
  yaml.refuseUnread();
  return spec;
}

Smp3oLearnerOptions readLearner(const YamlMap& yaml) {
  Smp3oLearnerOptions options;
  readNumber(yaml, "gamma", {0.0, 1.0}, options.gamma);
  readNumber(yaml, "lambda", {0.0, 1.0}, options.lambda);
  readNumber(yaml, "clip", Range::positive(), options.clip);
  readNumber(yaml, "stability_kappa", Range::positive(), options.stability_kappa);
  options.crossed_advantages = yaml.boolean("crossed_advantages", options.crossed_advantages);
  readNumber(yaml, "learning_rate", Range::positive(), options.learning_rate);
  readNumber(yaml, "gradient_norm", Range::positive(), options.gradient_norm);
  options.only_critic = yaml.boolean("only_critic", options.only_critic);
  readCount(yaml, "epochs", options.epochs);
  readCount(yaml, "minibatch", options.minibatch_rows);
  readCount(yaml, "sequence_length", options.sequence_length);
  if (const auto weights = yaml.map("loss")) {
    options.weights = readWeights(*weights);
  }
  return options;
}

}  // namespace

Smp3oSettings Smp3oSettings::read(const YamlMap& yaml) {
  Smp3oSettings settings;
  settings.steps = yaml.integer("steps", settings.steps, 1, 1000000000);
  readCount(yaml, "environments", settings.environments);
  readCount(yaml, "rollout_steps", settings.rollout_steps);
  settings.memory = yaml.boolean("memory", settings.memory);
  settings.precision = readPrecision(yaml);
  if (const auto worlds = yaml.map("worlds")) {
    settings.worlds = WorldSettings::read(*worlds);
  }
  if (const auto symmetric = yaml.map("symmetric")) {
    settings.symmetric = readSymmetric(*symmetric);
  }
  readCount(yaml, "validation_rollouts", settings.validation_rollouts);
  readCount(yaml, "validation_environments", settings.validation_environments);
  readNumber(yaml, "imitation_rate", {0.0, 1.0}, settings.imitation_rate);
  if (const auto imitation = yaml.map("imitation")) {
    settings.imitation = ImitationSettings::read(*imitation);
  }
  if (settings.imitation_rate > 0.0 && !settings.imitation) {
    throw yaml.error("imitation", "is missing, but imitation_rate is not 0");
  }
  settings.environment.tie_breaking = yaml.boolean("tie_breaking", true);
  readCount(yaml, "max_steps", settings.environment.max_steps);
  if (const auto rewards = yaml.map("rewards")) {
    settings.environment.rewards = readRewards(*rewards);
  }
  std::vector<std::string> modes;
  for (const auto& [name, mode] : svoModes()) {
    modes.push_back(name);
  }
  settings.svo.mode = svoModes().at(yaml.word("svo", modes, "learned"));
  const std::string feedback =
      yaml.word("svo_feedback", {"sample", "distribution"}, "distribution");
  settings.svo.feedback = feedback == "sample" ? SvoFeedback::Sample : SvoFeedback::Distribution;
  settings.learner = readLearner(yaml);
  yaml.word("kind", {"smp3o"}, yaml.text("kind"));
  yaml.refuseUnread();
  return settings;
}

}  // namespace sylph_training
