#include "sylph_core/benchmark/bootstrap.hpp"

#include <gtest/gtest.h>

namespace sylph {
namespace {

TEST(BootstrapTest, FewerThanTwoValuesHaveNoInterval) {
  Rng rng(1);
  EXPECT_FALSE(bootstrapMean({}, rng).has_value());
  EXPECT_FALSE(bootstrapMean({1.5}, rng).has_value());
}

TEST(BootstrapTest, EqualValuesHaveNoSpread) {
  Rng rng(1);
  const Interval interval = bootstrapMean({1.5, 1.5, 1.5}, rng).value();
  EXPECT_DOUBLE_EQ(1.5, interval.low);
  EXPECT_DOUBLE_EQ(1.5, interval.high);
}

TEST(BootstrapProperty, TheIntervalHasTheMeanOfThePopulationNineteenTimesOfTwenty) {
  int inside = 0;
  constexpr int kSeeds = 300;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Rng rng(seed);
    std::vector<double> values(40);
    for (double& value : values) {
      value = 3.0 + drawNormal(rng);
    }
    const Interval interval = bootstrapMean(values, rng).value();
    inside += interval.low <= 3.0 && 3.0 <= interval.high ? 1 : 0;
  }
  // Binomial of 300 draws: 95 % are 285, four standard deviations 15; the bootstrap is a little
  // narrow for 40 values.
  EXPECT_GT(inside, 265);
  EXPECT_LT(inside, 298);
}

}  // namespace
}  // namespace sylph
