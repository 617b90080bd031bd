#include "sylph_training/imitation/imitation_batch.hpp"

#include <gtest/gtest.h>

namespace sylph_training {
namespace {

/// Two agents that are each other's partners, one of them a sample.
Scene pairScene() {
  Scene scene;
  scene.agents = {{{1.F, 0.F, 0.5F, 0.5F, 0.F}, 1, 2}, {{0.F, 1.F, 0.25F, 0.5F, 0.F}, 0, 9}};
  Sample sample;
  sample.agent = 1;
  sample.action = 2;
  sample.yielding = Yielding::Yes;
  sample.regrets = {1, kImpossible, 0, 0, 4};
  sample.view[0] = 1U;
  scene.samples = {sample};
  return scene;
}

TEST(ImitationBatchTest, LabelsMixTheExpertWithTheRegrets) {
  SceneStore store;
  store.add(pairScene());
  sylph::Rng rng(1);
  const ImitationBatch batch = makeBatch({{&store, 0, 0}}, 8, {0.5, 0.25}, rng);
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
  EXPECT_EQ(1.0, batch.yields[0].item<double>());
}

TEST(ImitationBatchTest, LabelsTurnWithTheView) {
  SceneStore store;
  store.add(pairScene());
  sylph::Rng rng(1);
  const ImitationBatch batch = makeBatch({{&store, 0, 1}}, 8, {}, rng);  // a quarter clockwise
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
  other.agents[0].vector = {0.6F, 0.8F, 0.1F, 0.1F, 0.F};
  other.agents.push_back({{0.F, 0.F, 0.F, 0.F, 1.F}, 2, 9});
  store.add(other);
  torch::manual_seed(3);
  const torch::NoGradGuard no_grad;
  PolicyModel model((sylph::NetworkShape()));
  sylph::Rng rng(1);
  ImitationBatch both = makeBatch({{&store, 0, 0}, {&store, 1, 3}}, 128, {}, rng);
  ImitationBatch second = makeBatch({{&store, 1, 3}}, 128, {}, rng);
  ASSERT_EQ(2, both.sampleCount());
  ASSERT_EQ(5, both.input.svo.size(0));
  EXPECT_TRUE(torch::allclose(both.input.svo.sum(1), torch::ones({5})));
  second.input.svo = both.input.svo.narrow(0, 2, 3);
  const torch::Tensor expected = model->forward(second.input).actions;
  const torch::Tensor actions = model->forward(both.input).actions.narrow(0, 1, 1);
  EXPECT_TRUE(torch::allclose(expected, actions, 1e-4, 1e-5));
}

}  // namespace
}  // namespace sylph_training
