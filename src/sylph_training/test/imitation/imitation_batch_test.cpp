#include "sylph_training/imitation/imitation_batch.hpp"

#include <gtest/gtest.h>

#include "sylph_training/imitation/imitation_phase.hpp"

namespace sylph_training {
namespace {

constexpr std::size_t kCentre = sylph::kViewCells / 2;
constexpr std::uint64_t kNearerEast = std::uint64_t{1}
                                      << static_cast<int>(sylph::Channel::NearerEast);
constexpr std::uint64_t kNearerSouth = std::uint64_t{1}
                                       << static_cast<int>(sylph::Channel::NearerSouth);

/// Two agents that are each other's partners, one of them a sample.
Scene pairScene() {
  Scene scene;
  scene.agents = {{{1.F, 0.F, 0.5F, 0.5F, 0.F, 1.F, 0.5F}, 1, 1000},
                  {{0.F, 1.F, 0.25F, 0.5F, 0.F, 0.5F, 1.F}, 0, 3725}};
  Sample sample;
  sample.agent = 1;
  sample.action = 2;
  sample.regrets = {1, kImpossible, 0, 0, 4};
  sample.view[0] = 1U;
  sample.view[kCentre] = kNearerEast | kNearerSouth;
  scene.samples = {sample};
  return scene;
}

TEST(ImitationBatchTest, LabelsMixTheExpertWithTheRegrets) {
  SceneStore store;
  store.add(pairScene());
  const ImitationBatch batch = makeBatch({{&store, 0, 0}}, 8, {0.5, 0.25});
  const double rest = 2.0 + std::exp(-4.0) + std::exp(-16.0);
  const std::vector<double> expected = {0.5 * std::exp(-4.0) / rest, 0.0, 0.5 + 0.5 / rest,
                                        0.5 / rest, 0.5 * std::exp(-16.0) / rest};
  for (int action = 0; action < sylph::kActionCount; ++action) {
    EXPECT_NEAR(expected[static_cast<std::size_t>(action)], batch.targets[0][action].item<double>(),
                1e-6);
  }
  EXPECT_EQ(2, batch.actions[0].item<int>());
  EXPECT_TRUE(torch::equal(batch.is_best, torch::tensor({{0.F, 0.F, 1.F, 1.F, 0.F}})));
  EXPECT_TRUE(torch::equal(batch.is_valid, torch::tensor({{1.F, 0.F, 1.F, 1.F, 1.F}})));
  EXPECT_TRUE(torch::equal(batch.is_compared, torch::ones({1, 5})));
}

TEST(ImitationBatchTest, LabelsAreTheSharesOfTheTeachersVotes) {
  Scene scene = pairScene();
  scene.samples[0].votes = {1, 0, 3, 0, 0};
  SceneStore store;
  store.add(scene);
  const ImitationBatch batch = makeBatch({{&store, 0, 0}}, 8, {0.5, 0.25});
  EXPECT_TRUE(torch::equal(batch.targets, torch::tensor({{0.25F, 0.F, 0.75F, 0.F, 0.F}})));
  EXPECT_TRUE(torch::equal(batch.is_alike, torch::tensor({{0.F, 0.F, 1.F, 1.F, 0.F}})));
}

TEST(ImitationBatchTest, TiesTellOnlyOfMovesThatComeCloser) {
  Scene scene = pairScene();
  scene.samples[0].only_ties = 1;
  scene.samples[0].action = 0;  // the expert waited
  SceneStore store;
  store.add(scene);
  const ImitationBatch batch = makeBatch({{&store, 0, 0}}, 8, {0.5, 0.25});
  EXPECT_TRUE(torch::allclose(batch.targets, torch::tensor({{0.F, 0.F, 0.5F, 0.5F, 0.F}})));
  EXPECT_TRUE(torch::equal(batch.is_compared, torch::tensor({{0.F, 0.F, 1.F, 1.F, 0.F}})));
}

TEST(ImitationLossTest, WhatTellsAHeadNothingDoesNotCount) {
  SceneStore store;
  store.add(pairScene());
  Scene voted = pairScene();
  voted.samples[0].votes = {0, 0, 4, 0, 0};
  store.add(voted);
  Scene without_choice = pairScene();
  without_choice.samples[0].only_ties = 1;
  without_choice.samples[0].view[kCentre] = 0;
  store.add(without_choice);
  torch::manual_seed(3);
  PolicyModel model((sylph::NetworkShape()));
  const auto lossOf = [&](const std::vector<Pick>& picks) {
    return imitationLoss(model, makeBatch(picks, 128, {}), ImitationSettings());
  };
  const ImitationLoss all = lossOf({{&store, 0, 0}, {&store, 1, 0}, {&store, 2, 0}});
  EXPECT_EQ(2.0, all.told);
  EXPECT_EQ(3.0, all.samples);
  EXPECT_NEAR(lossOf({{&store, 0, 0}, {&store, 1, 0}}).cross_entropy, all.cross_entropy, 1e-5);
}

TEST(ImitationBatchTest, SvosAreWhatAllSeeAndTargetsWhatWaitingGives) {
  SceneStore store;
  store.add(pairScene());
  const ImitationBatch batch = makeBatch({{&store, 0, 0}}, 8, {});
  // 37.25 degrees lie between 35 and 40; 32 timesteps make level 7, the tie break adds 0.9.
  EXPECT_NEAR(0.55, batch.input.svo[1][7].item<double>(), 1e-5);
  EXPECT_NEAR(0.45, batch.input.svo[1][8].item<double>(), 1e-5);
  EXPECT_NEAR(0.1, batch.svo_targets[0][7].item<double>(), 1e-5);
  EXPECT_NEAR(0.9, batch.svo_targets[0][8].item<double>(), 1e-5);
}

TEST(ImitationBatchTest, LabelsTurnWithTheView) {
  SceneStore store;
  store.add(pairScene());
  const ImitationBatch batch = makeBatch({{&store, 0, 1}}, 8, {});  // a quarter clockwise
  EXPECT_EQ(3, batch.actions[0].item<int>());
  EXPECT_TRUE(torch::equal(batch.is_best, torch::tensor({{0.F, 0.F, 0.F, 1.F, 1.F}})));
  EXPECT_EQ(0.F, batch.input.views[0][0][0][0].item<float>());
  EXPECT_EQ(1.F, batch.input.views[0][0][0][8].item<float>());
  EXPECT_EQ(0.F, batch.input.vectors[0][0].item<float>());
  EXPECT_EQ(-1.F, batch.input.vectors[0][1].item<float>());
}

TEST(ImitationBatchTest, ScenesDoNotSeeEachOther) {
  SceneStore store;
  store.add(pairScene());
  Scene other = pairScene();
  other.agents[0].vector = {0.6F, 0.8F, 0.1F, 0.1F, 0.F, 0.1F, 0.F};
  other.agents.push_back({{0.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F}, 2, 4500});
  store.add(other);
  torch::manual_seed(3);
  const torch::NoGradGuard no_grad;
  PolicyModel model((sylph::NetworkShape()));
  const ImitationBatch both = makeBatch({{&store, 0, 0}, {&store, 1, 3}}, 128, {});
  const ImitationBatch second = makeBatch({{&store, 1, 3}}, 128, {});
  ASSERT_EQ(2, both.sampleCount());
  ASSERT_EQ(5, both.input.svo.size(0));
  EXPECT_TRUE(torch::allclose(both.input.svo.sum(1), torch::ones({5})));
  EXPECT_TRUE(torch::equal(both.input.svo.narrow(0, 2, 3), second.input.svo));
  const torch::Tensor expected = model->forward(second.input).actions;
  const torch::Tensor actions = model->forward(both.input).actions.narrow(0, 1, 1);
  EXPECT_TRUE(torch::allclose(expected, actions, 1e-4, 1e-5));
}

}  // namespace
}  // namespace sylph_training
