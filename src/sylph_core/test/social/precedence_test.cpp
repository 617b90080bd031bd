#include "sylph_core/social/precedence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sylph_core/social/svo.hpp"

namespace sylph {
namespace {

TEST(SvoByWaitingTest, FallsALevelEveryTwentyTimesteps) {
  EXPECT_EQ(45.F, svoByPriority(0, 0.5F)) << "on the goal";
  EXPECT_EQ(40.F, svoByPriority(1, 0.F));
  EXPECT_EQ(40.F, svoByPriority(19, 0.F));
  EXPECT_EQ(35.F, svoByPriority(20, 0.F));
  EXPECT_EQ(0.F, svoByPriority(160, 0.F));
  EXPECT_EQ(0.F, svoByPriority(100000, 0.F));
}

TEST(SvoByWaitingTest, TieBreaksNeverOverruleALevel) {
  EXPECT_FLOAT_EQ(44.5F, svoByPriority(1, 1.F));
  EXPECT_LT(svoByPriority(20, 1.F), svoByPriority(19, 0.F));
  EXPECT_LT(svoByPriority(5, 0.1F), svoByPriority(5, 0.2F));
}

TEST(SpreadOverLevelsTest, HasTheAngleAsItsMean) {
  std::vector<float> probabilities(kSvoLevelCount);
  for (float svo_deg = 0.F; svo_deg <= 45.F; svo_deg += 0.75F) {
    spreadOverLevels(svo_deg, probabilities.data());
    EXPECT_NEAR(svo_deg, meanSvo(probabilities), 1e-4);
    EXPECT_LE(kSvoLevelCount - 2, std::count(probabilities.begin(), probabilities.end(), 0.F));
  }
}

}  // namespace
}  // namespace sylph
