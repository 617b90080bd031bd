#include "sylph_training/model/policy_model.hpp"

#include <gtest/gtest.h>

#include "sylph_core/grid/rng.hpp"
#include "sylph_core/policy/observation.hpp"

namespace sylph_training {
namespace {

sylph::AgentRows toRows(const torch::Tensor& tensor) {
  const torch::Tensor rows = tensor.detach().reshape({tensor.size(0), -1}).contiguous();
  return Eigen::Map<const sylph::AgentRows>(rows.data_ptr<float>(), rows.size(0), rows.size(1));
}

void expectSameOutputs(const sylph::NetworkShape& shape, int agents, int threads) {
  torch::manual_seed(agents);
  PolicyModel model(shape);
  const torch::NoGradGuard no_grad;
  sylph::Rng rng(static_cast<unsigned>(agents));
  std::vector<std::int64_t> partners;
  partners.reserve(static_cast<std::size_t>(agents));
  for (int agent = 0; agent < agents; ++agent) {
    partners.push_back(
        static_cast<std::int64_t>(sylph::drawIndex(rng, static_cast<std::size_t>(agents))));
  }
  PolicyInput input;
  input.views = torch::rand({agents, shape.channels, sylph::kFieldOfView, sylph::kFieldOfView});
  input.vectors = torch::randn({agents, shape.vector_size});
  input.svo = torch::softmax(torch::randn({agents, shape.svo_levels}), 1);
  input.memory = torch::randn({agents, shape.width});
  std::tie(input.hop1, input.hop2) = hopMatrices(partners);
  const PolicyOutput expected = model->forward(input);

  const sylph::Network network(shape, exportWeights(model), "exported");
  const sylph::NetworkOutput output = network.forward(
      {toRows(input.views.permute({0, 2, 3, 1})), toRows(input.vectors), toRows(input.svo),
       toRows(input.memory), std::vector<sylph::AgentId>(partners.begin(), partners.end())},
      threads);
  EXPECT_LT((toRows(expected.memory) - output.memory).cwiseAbs().maxCoeff(), 1e-4F);
  EXPECT_LT((toRows(expected.actions) - output.actions).cwiseAbs().maxCoeff(), 1e-4F);
  EXPECT_LT((toRows(expected.svo) - output.svo).cwiseAbs().maxCoeff(), 1e-4F);
  EXPECT_LT((toRows(expected.values) - output.values).cwiseAbs().maxCoeff(), 1e-4F);
  EXPECT_LT((toRows(expected.blocking) - output.blocking).cwiseAbs().maxCoeff(), 1e-4F);
}

TEST(PolicyModelTest, ComputesWhatTheNetworkOfTheCoreComputes) {
  for (const int agents : {1, 2, 7, 30}) {
    SCOPED_TRACE(agents);
    expectSameOutputs({}, agents, 1 + agents % 2);
  }
}

TEST(PolicyModelTest, OtherWidthsToo) {
  sylph::NetworkShape shape;
  shape.near_width = 12;
  shape.far_width = 20;
  shape.goal_width = 6;
  shape.message_width = 9;
  shape.message_heads = 3;
  shape.width = 50;
  shape.heads = 5;
  shape.semantic_tokens = 7;
  expectSameOutputs(shape, 9, 2);
}

TEST(PolicyModelTest, AnLstmRemembersInsteadOfTheSemanticTransformer) {
  torch::manual_seed(1);
  const sylph::NetworkShape shape;
  PolicyModel model(shape, Decoder::Lstm);
  EXPECT_EQ(2 * shape.width, model->memoryWidth());
  EXPECT_EQ(0U, exportWeights(model).tensors.count("semantic.positions"));
  const torch::NoGradGuard no_grad;
  const torch::Tensor features = torch::randn({3, shape.width});
  const torch::Tensor blank = torch::zeros({3, model->memoryWidth()});
  const PolicyOutput first = model->decide(features, blank);
  const PolicyOutput second = model->decide(features, first.memory);
  EXPECT_EQ((std::vector<std::int64_t>{3, model->memoryWidth()}), first.memory.sizes().vec());
  EXPECT_GT((first.actions - second.actions).abs().max().item<float>(), 1e-4F);
  EXPECT_TRUE(torch::equal(first.actions, model->decide(features, blank).actions));
}

TEST(PolicyModelTest, WeightsThereAndBackAreTheSame) {
  PolicyModel first((sylph::NetworkShape()));
  PolicyModel second((sylph::NetworkShape()));
  importWeights(exportWeights(first), second);
  const auto expected = exportWeights(first);
  const auto read = exportWeights(second);
  ASSERT_EQ(expected.tensors.size(), read.tensors.size());
  for (const auto& [name, tensor] : expected.tensors) {
    EXPECT_EQ(tensor.values, read.tensors.at(name).values) << name;
  }
}

TEST(PolicyModelTest, RefusesWeightsThatLackATensor) {
  PolicyModel first((sylph::NetworkShape()));
  PolicyModel second((sylph::NetworkShape()));
  sylph::TensorFile broken = exportWeights(first);
  broken.tensors.erase("goal.bias");
  EXPECT_THROW(importWeights(broken, second), std::invalid_argument);
}

}  // namespace
}  // namespace sylph_training
