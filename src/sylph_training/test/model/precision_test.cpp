#include "sylph_training/model/precision.hpp"

#include <gtest/gtest.h>

namespace sylph_training {
namespace {

TEST(PrecisionTest, AutoTakesWhatIsMeasuredFaster) {
  PolicyModel model((sylph::NetworkShape()));
  EXPECT_EQ(torch::kFloat, encoderType(Precision::Float, model, torch::kCPU));
  EXPECT_EQ(torch::kBFloat16, encoderType(Precision::Bfloat16, model, torch::kCPU));
  const double bfloat16 = measureLearningRate(model, torch::kBFloat16, torch::kCPU);
  const double single = measureLearningRate(model, torch::kFloat, torch::kCPU);
  EXPECT_GT(bfloat16, 0.0);
  if (std::max(single, bfloat16) > 3.0 * std::min(single, bfloat16)) {  // beyond doubt
    EXPECT_EQ(bfloat16 > single ? torch::kBFloat16 : torch::kFloat,
              encoderType(Precision::Auto, model, torch::kCPU));
  }
}

TEST(PrecisionTest, MeasuringLeavesTheWeightsAndNoGradient) {
  PolicyModel model((sylph::NetworkShape()));
  const torch::Tensor before = model->parameters().front().detach().clone();
  encoderType(Precision::Auto, model, torch::kCPU);
  EXPECT_TRUE(torch::equal(before, model->parameters().front()));
  for (const torch::Tensor& parameter : model->parameters()) {
    EXPECT_TRUE(!parameter.grad().defined() || parameter.grad().abs().max().item<float>() == 0.F);
  }
}

}  // namespace
}  // namespace sylph_training
