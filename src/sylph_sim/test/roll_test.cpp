#include "sylph_sim/roll.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using sylph_sim::Roll;
using Stage = Roll::Stage;
using Names = std::vector<std::string>;

constexpr double kLimit_s = 2.0;

class RollTest : public testing::Test {
 protected:
  void answer(const std::string& node, Stage stage, std::uint32_t number, double wall_s) {
    roll_.note({node, stage, number, true, false}, wall_s);
  }

  Roll roll_{{"/bridge", "/robot"}, kLimit_s};
};

TEST_F(RollTest, TheLabBeginsWhenAllWhoAreExpectedAreReady) {
  EXPECT_EQ((Names{"/bridge", "/robot"}), roll_.unready());
  roll_.note({"/bridge", Stage::First, 0, true, false}, 0.0);
  roll_.note({"/robot", Stage::Second, 0, false, false}, 0.0);
  EXPECT_EQ(Names{"/robot"}, roll_.unready());
  roll_.note({"/robot", Stage::Second, 0, true, false}, 0.1);
  EXPECT_EQ(Names{}, roll_.unready());
  roll_.note({"/mission", Stage::StartOnly, 0, false, false}, 0.1);
  EXPECT_EQ(Names{"/mission"}, roll_.unready());
}

TEST_F(RollTest, WaitsForTheStageThatWasCalled) {
  answer("/bridge", Stage::First, 0, 0.0);
  answer("/robot", Stage::Second, 0, 0.0);
  answer("/mission", Stage::StartOnly, 0, 0.0);
  roll_.call(Stage::First, 1, 0.0);
  EXPECT_FALSE(roll_.hasAnswered());
  answer("/robot", Stage::Second, 1, 0.1);
  EXPECT_FALSE(roll_.hasAnswered());
  answer("/bridge", Stage::First, 1, 0.1);
  EXPECT_TRUE(roll_.hasAnswered());
  roll_.call(Stage::Second, 1, 0.1);
  EXPECT_TRUE(roll_.hasAnswered());
  roll_.call(Stage::Second, 2, 0.2);
  EXPECT_FALSE(roll_.hasAnswered());
}

TEST_F(RollTest, TellsOfASilentNodeOnceAndGoesOnWithoutIt) {
  answer("/robot", Stage::Second, 0, 0.0);
  roll_.call(Stage::Second, 1, 10.0);
  EXPECT_EQ(Names{}, roll_.findSilent(10.0 + kLimit_s));
  EXPECT_EQ(Names{"/robot"}, roll_.findSilent(10.1 + kLimit_s));
  EXPECT_TRUE(roll_.hasAnswered());
  EXPECT_EQ(Names{}, roll_.findSilent(20.0));
  roll_.call(Stage::Second, 2, 20.0);
  EXPECT_TRUE(roll_.hasAnswered());
  const Roll::Return back = roll_.note({"/robot", Stage::Second, 2, true, false}, 25.0);
  EXPECT_TRUE(back.is_new);
  EXPECT_DOUBLE_EQ(25.0, back.silent_s);
  roll_.call(Stage::Second, 3, 25.0);
  EXPECT_FALSE(roll_.hasAnswered());
}

TEST_F(RollTest, NobodyWaitsForANodeThatHasEnded) {
  answer("/bridge", Stage::First, 0, 0.0);
  answer("/robot", Stage::Second, 0, 0.0);
  roll_.call(Stage::Second, 1, 0.0);
  roll_.leave("/robot");
  EXPECT_TRUE(roll_.hasAnswered());
  EXPECT_EQ(Names{}, roll_.silent());
  EXPECT_EQ(Names{"/robot"}, roll_.unready());
  EXPECT_TRUE(roll_.note({"/robot", Stage::Second, 1, true, false}, 1.0).is_new);
}

TEST_F(RollTest, ABusyNodeIsWaitedForAsLongAsItSaysSo) {
  answer("/planner", Stage::Second, 0, 0.0);
  roll_.call(Stage::Second, 1, 0.0);
  for (double wall_s = 0.0; wall_s < 10.0; wall_s += 1.0) {
    roll_.note({"/planner", Stage::Second, 1, true, true}, wall_s);
    EXPECT_EQ(Names{}, roll_.findSilent(wall_s + 0.9));
    EXPECT_FALSE(roll_.hasAnswered());
  }
  EXPECT_EQ(Names{"/planner"}, roll_.findSilent(9.1 + kLimit_s));
}

}  // namespace
