#include "sylph_core/social/svo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace sylph {
namespace {

TEST(SvoTest, LevelsRunFromSelfishToProsocial) {
  EXPECT_DOUBLE_EQ(0.0, svoOfLevel(0));
  EXPECT_DOUBLE_EQ(45.0, svoOfLevel(kMostProsocialLevel));
  EXPECT_THROW(svoOfLevel(-1), std::out_of_range);
  EXPECT_THROW(svoOfLevel(kSvoLevelCount), std::out_of_range);
}

TEST(SvoTest, MeanWeighsLevelsByProbability) {
  std::vector<float> probabilities(kSvoLevelCount, 0.F);
  probabilities[0] = 1.F;
  probabilities[4] = 3.F;
  EXPECT_NEAR(15.0, meanSvo(probabilities), 1e-9);
  EXPECT_THROW(meanSvo(std::vector<float>(kSvoLevelCount, 0.F)), std::invalid_argument);
  EXPECT_THROW(meanSvo({1.F}), std::invalid_argument);
}

TEST(SvoTest, SelfishCountsOnlyItselfAndProsocialBothAlike) {
  EXPECT_DOUBLE_EQ(-0.3, redistributedReward(-0.3, -2.0, 0.0));
  EXPECT_NEAR((-0.3 - 2.0) / std::sqrt(2.0), redistributedReward(-0.3, -2.0, 45.0), 1e-12);
  EXPECT_DOUBLE_EQ(-1.15, socialReward(-0.3, -2.0));
}

}  // namespace
}  // namespace sylph
