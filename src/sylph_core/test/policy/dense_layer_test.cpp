#include "sylph_core/policy/dense_layer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sylph_core/grid/rng.hpp"

namespace sylph {
namespace {

std::vector<float> randomValues(std::size_t count, Rng& rng) {
  std::vector<float> values(count);
  for (float& value : values) {
    value = static_cast<float>(drawBetween(rng, -1.0, 1.0));
  }
  return values;
}

TEST(DenseLayerProperty, EqualsTheDefinition) {
  Rng rng(1);
  for (const int outputs : {1, 5, 16, 17, 32, 80, 128}) {
    for (const int inputs : {1, 3, 63, 128}) {
      for (const int count : {1, 3, 4, 9}) {
        const auto weight = randomValues(static_cast<std::size_t>(outputs * inputs), rng);
        const auto bias = randomValues(static_cast<std::size_t>(outputs), rng);
        const auto in = randomValues(static_cast<std::size_t>(count * inputs), rng);
        std::vector<float> out(static_cast<std::size_t>(count * outputs));
        const DenseLayer layer(outputs, inputs, weight, bias);
        layer.apply(in.data(), count, out.data(), DenseLayer::Activation::Relu);
        for (int row = 0; row < count; ++row) {
          for (int output = 0; output < outputs; ++output) {
            double sum = bias[static_cast<std::size_t>(output)];
            for (int input = 0; input < inputs; ++input) {
              sum +=
                  static_cast<double>(weight[static_cast<std::size_t>(output * inputs + input)]) *
                  in[static_cast<std::size_t>(row * inputs + input)];
            }
            ASSERT_NEAR(std::max(sum, 0.0), out[static_cast<std::size_t>(row * outputs + output)],
                        1e-4)
                << outputs << " x " << inputs << ", row " << row << " of " << count;
          }
        }
      }
    }
  }
}

TEST(DenseLayerTest, GathersSegmentsThatLieApart) {
  const DenseLayer layer(1, 4, {1.F, 10.F, 100.F, 1000.F}, {0.5F});
  const std::vector<float> in = {1.F, 2.F, -1.F, -1.F, -1.F, 3.F, 4.F};
  float out = 0.F;
  DenseLayer::Rows rows;
  rows.inputs = {in.data()};
  rows.outputs = {&out};
  rows.segments = 2;
  rows.segment_stride = 5;
  layer.apply(rows, DenseLayer::Activation::None);
  EXPECT_FLOAT_EQ(4321.5F, out);
}

TEST(DenseLayerTest, RefusesSizesThatDisagree) {
  EXPECT_THROW(DenseLayer(2, 2, {1.F, 2.F, 3.F}, {0.F, 0.F}), std::invalid_argument);
  EXPECT_THROW(DenseLayer(2, 1, {1.F, 2.F}, {0.F}), std::invalid_argument);
  EXPECT_THROW(DenseLayer(0, 1, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sylph
