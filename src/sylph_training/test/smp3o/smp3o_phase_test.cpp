#include "sylph_training/smp3o/smp3o_phase.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "sylph_training/imitation/shards.hpp"
#include "sylph_training/model/learner.hpp"
#include "sylph_training/run/threads.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph_training {
namespace {

constexpr char kSmall[] =
    "network: {near_width: 4, far_width: 4, goal_width: 4, message_width: 4, width: 16, "
    "semantic_tokens: 4}\n";

TrainingSettings settingsFrom(const std::string& phase) {
  const sylph::TemporaryFolder folder;
  return TrainingSettings::load(folder.write(
      "config.yaml", kSmall + ("phases: [{kind: smp3o, precision: float, " + phase + "}]\n")));
}

RunState stateOf(const TrainingSettings& settings) {
  useThreads(1);
  torch::manual_seed(3);
  RunState state{settings, "", PolicyModel(settings.network, settings.decoder),
                 PolicyModel(settings.network, settings.decoder)};
  copyWeights(state.model, state.average);
  return state;
}

void expectError(const std::string& phase, const std::string& field) {
  const TrainingSettings settings = settingsFrom(phase);
  try {
    Smp3oSettings::read(settings.phases.front());
    ADD_FAILURE() << phase << " was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find(field)) << error.what();
  }
}

TEST(Smp3oSettingsTest, DefaultsAreThoseOfThePaper) {
  const auto settings = Smp3oSettings::read(settingsFrom("steps: 1").phases.front());
  EXPECT_EQ(16, settings.environments);
  EXPECT_EQ(256, settings.rollout_steps);
  EXPECT_EQ(256, settings.environment.max_steps);
  EXPECT_EQ(-0.3, settings.environment.rewards.move);
  EXPECT_EQ(-0.3, settings.environment.rewards.stay_off_goal);
  EXPECT_EQ(0.0, settings.environment.rewards.stay_on_goal);
  EXPECT_EQ(-2.0, settings.environment.rewards.collision);
  EXPECT_EQ(-1.0, settings.environment.rewards.blocking);
  EXPECT_EQ(2.0, settings.environment.rewards.svo_importance);
  EXPECT_EQ(0.95, settings.learner.gamma);
  EXPECT_EQ(0.95, settings.learner.lambda);
  EXPECT_EQ(0.2, settings.learner.clip);
  EXPECT_EQ(1e-5, settings.learner.learning_rate);
  EXPECT_EQ(10.0, settings.learner.gradient_norm);
  EXPECT_EQ(10, settings.learner.epochs);
  EXPECT_EQ(10.0, settings.learner.weights.policy);
  EXPECT_EQ(0.08, settings.learner.weights.value);
  EXPECT_EQ(0.01, settings.learner.weights.entropy);
  EXPECT_EQ(0.5, settings.learner.weights.valid);
  EXPECT_EQ(0.5, settings.learner.weights.blocking);
  EXPECT_EQ(0.0, settings.imitation_rate);
  EXPECT_TRUE(settings.learner.crossed_advantages);
}

TEST(Smp3oSettingsTest, MalformedFieldsAreNamed) {
  expectError("stesp: 4", "stesp");
  expectError("svo: kind", "svo");
  expectError("gamma: 1.5", "gamma");
  expectError("loss: {policy: -1}", "loss.policy");
  expectError("rewards: {svo_importance: 0}", "rewards.svo_importance");
  expectError("symmetric: {min_length: 3}", "symmetric.min_length");
  expectError("imitation_rate: 0.5", "imitation");
}

TEST(Smp3oPhaseTest, MakesScenesWhenItIsPreparedAndNotBefore) {
  const sylph::TemporaryFolder folder;
  TrainingSettings settings = settingsFrom(
      "steps: 1, imitation_rate: 0.5, symmetric: {}, "
      "imitation: {kind: imitation, first_shards: 1, precision: float}");
  settings.validation_shards = settings.worlds_per_shard = 1;
  settings.worlds.side = settings.worlds.usual_side = {10, 10};
  settings.worlds.most_agents = 5;
  settings.demonstrations.improvement_s = 0.001;
  RunState state = stateOf(settings);
  state.folder = folder.path("run");
  Smp3oPhase phase(Smp3oSettings::read(settings.phases.front()), state);
  EXPECT_FALSE(std::filesystem::exists(state.folder));
  phase.prepare();
  EXPECT_TRUE(std::filesystem::exists(shardPath(state.folder + "/demonstrations", 0)));
}

TEST(Smp3oPhaseTest, GoesOnFromACheckpointAsIfNothingHadHappened) {
  const TrainingSettings settings = settingsFrom(
      "steps: 3, environments: 2, rollout_steps: 12, max_steps: 10, minibatch: 32, epochs: 2, "
      "learning_rate: 0.001, sequence_length: 3, symmetric: {}");
  const auto phase_settings = Smp3oSettings::read(settings.phases.front());
  RunState state = stateOf(settings);
  Smp3oPhase phase(phase_settings, state);
  ASSERT_TRUE(phase.step(0));
  torch::serialize::OutputArchive saved;
  phase.save(saved);
  const sylph::TensorFile weights = exportWeights(state.model);
  const sylph::TemporaryFolder folder;
  saved.save_to(folder.path("phase.pt"));
  ASSERT_TRUE(phase.step(1));

  RunState resumed_state = stateOf(settings);
  importWeights(weights, resumed_state.model);
  importWeights(weights, resumed_state.average);
  Smp3oPhase resumed(phase_settings, resumed_state);
  torch::serialize::InputArchive archive;
  archive.load_from(folder.path("phase.pt"));
  resumed.load(archive);
  ASSERT_TRUE(resumed.step(1));
  for (const auto& [name, tensor] : exportWeights(state.model).tensors) {
    EXPECT_EQ(tensor.values, exportWeights(resumed_state.model).tensors.at(name).values) << name;
  }
  EXPECT_EQ(phase.notes(), resumed.notes());
  EXPECT_EQ("true", phase.notes().at("memory"));
}

TEST(Smp3oPhaseTest, ValidatesOnTheSameWorldsAgainAndAgain) {
  const TrainingSettings settings = settingsFrom(
      "steps: 3, environments: 2, rollout_steps: 4, max_steps: 10, minibatch: 32, epochs: 1, "
      "learning_rate: 1.0e-12, symmetric: {}, validation_rollouts: 2, validation_environments: 6");
  RunState state = stateOf(settings);
  Smp3oPhase phase(Smp3oSettings::read(settings.phases.front()), state);
  const auto validated = [&](long step) {
    const Figures figures = phase.step(step).value();
    return std::vector<Figures::value_type>(figures.end() - 4, figures.end());
  };
  const auto at_first = validated(0);
  EXPECT_EQ("validation_solved", at_first.front().first);
  EXPECT_LT(at_first.back().second, 0.0);  // the reward of a policy that knows nothing
  EXPECT_EQ(at_first, validated(1));
  EXPECT_EQ(at_first, validated(2));  // measured anew, of a policy that has hardly changed
}

TEST(Smp3oPhaseTest, CountsTheFirstEpisodeOfEachWorldOnly) {
  std::vector<EpisodeRecord> episodes(4);
  episodes[0].world = 1;
  episodes[0].steps = 9;
  episodes[1].world = 0;
  episodes[2].world = 1;
  episodes[3].world = 0;
  const auto first = firstEpisodes(episodes);
  ASSERT_EQ(2U, first.size());
  EXPECT_EQ(9, first[0].steps);
  EXPECT_EQ(0, first[1].world);
}

TEST(Smp3oPhaseTest, LearnsWithAnLstmToo) {
  TrainingSettings settings = settingsFrom(
      "steps: 1, environments: 2, rollout_steps: 8, max_steps: 10, minibatch: 32, epochs: 1, "
      "sequence_length: 4, symmetric: {}, learning_rate: 0.001");
  settings.decoder = Decoder::Lstm;
  RunState state = stateOf(settings);
  const auto before = exportWeights(state.model).tensors.at("lstm.weight_hh").values;
  Smp3oPhase phase(Smp3oSettings::read(settings.phases.front()), state);
  const auto figures = phase.step(0);
  ASSERT_TRUE(figures);
  EXPECT_NE(before, exportWeights(state.model).tensors.at("lstm.weight_hh").values);
}

}  // namespace
}  // namespace sylph_training
