#include "sylph_core/grid/rng.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace sylph {
namespace {

constexpr int kDraws = 20000;

TEST(RngTest, DrawsAreTheSameEverywhere) {
  Rng rng(1);
  EXPECT_EQ(1791095845U, rng());
  EXPECT_EQ(9U, drawIndex(rng, 10));
  EXPECT_DOUBLE_EQ(3093770124.0 / 4294967296.0, drawFraction(rng));
  std::vector<int> values = {1, 2, 3, 4, 5};
  shuffle(values, rng);
  EXPECT_EQ((std::vector<int>{1, 3, 2, 5, 4}), values);
}

// 2^32 is no multiple of the count: a remainder alone would prefer the lower third by two to one.
TEST(RngTest, NoIndexIsPreferred) {
  constexpr std::size_t kThird = std::size_t{1} << 30;
  Rng rng(2);
  int low = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    low += drawIndex(rng, 3 * kThird) < kThird ? 1 : 0;
  }
  EXPECT_NEAR(kDraws / 3.0, low, 0.02 * kDraws);
}

TEST(RngTest, AnyOrderIsAsLikely) {
  Rng rng(3);
  std::map<std::vector<int>, int> counts;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<int> values = {0, 1, 2};
    shuffle(values, rng);
    ++counts[values];
  }
  ASSERT_EQ(6U, counts.size());
  for (const auto& [values, count] : counts) {
    EXPECT_NEAR(kDraws / 6.0, count, 0.02 * kDraws);
  }
}

TEST(RngTest, WeightsAreProbabilities) {
  const std::array<double, 5> weights = {0.0, 1.0, 3.0, 0.0, 4.0};
  std::array<int, 5> counts{};
  Rng rng(4);
  for (int draw = 0; draw < kDraws; ++draw) {
    ++counts.at(drawByWeight(rng, weights.size(), [&](std::size_t i) { return weights[i]; }));
  }
  for (std::size_t index = 0; index < weights.size(); ++index) {
    EXPECT_NEAR(kDraws * weights[index] / 8.0, counts[index], 0.02 * kDraws) << index;
  }
  EXPECT_EQ(0, counts[0] + counts[3]);
}

TEST(RngTest, WithoutWeightsAllIndicesAreAsLikely) {
  Rng rng(5);
  std::array<int, 4> counts{};
  for (int draw = 0; draw < kDraws; ++draw) {
    ++counts.at(drawByWeight(rng, counts.size(), [](std::size_t) { return 0; }));
  }
  for (const int count : counts) {
    EXPECT_NEAR(kDraws / 4.0, count, 0.02 * kDraws);
  }
}

TEST(RngTest, TheLargestLogitWithGumbelNoiseIsADrawByTheirSoftmax) {
  const std::array<double, 3> logits = {0.0, std::log(2.0), std::log(5.0)};
  std::array<int, 3> counts{};
  Rng rng(7);
  for (int draw = 0; draw < kDraws; ++draw) {
    std::array<double, 3> keys{};
    for (std::size_t index = 0; index < logits.size(); ++index) {
      keys.at(index) = logits.at(index) + drawGumbel(rng);
    }
    ++counts.at(
        static_cast<std::size_t>(std::max_element(keys.begin(), keys.end()) - keys.begin()));
  }
  for (std::size_t index = 0; index < logits.size(); ++index) {
    EXPECT_NEAR(kDraws * std::exp(logits.at(index)) / 8.0, counts.at(index), 0.02 * kDraws);
  }
}

TEST(RngTest, NormalDrawsHaveTheirMomentsAndTails) {
  Rng rng(6);
  double sum = 0.0;
  double squares = 0.0;
  int beyond_two = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const double value = drawNormal(rng);
    ASSERT_TRUE(std::isfinite(value));
    sum += value;
    squares += value * value;
    beyond_two += std::abs(value) > 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(0.0, sum / kDraws, 0.03);
  EXPECT_NEAR(1.0, squares / kDraws, 0.05);
  EXPECT_NEAR(0.0455, static_cast<double>(beyond_two) / kDraws, 0.005);
}

}  // namespace
}  // namespace sylph
