#include "sylph_sim/lock_step_members.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using sylph_sim::LockStepMembers;
using Stage = LockStepMembers::Stage;
using Names = std::vector<std::string>;

constexpr double kLimit_s = 2.0;

class LockStepMembersTest : public testing::Test {
 protected:
  void answer(const std::string& node, Stage stage, std::uint32_t number, double wall_s) {
    members_.note({node, stage, number, true, false}, wall_s);
  }

  LockStepMembers members_{{"/bridge", "/robot"}, kLimit_s};
};

TEST_F(LockStepMembersTest, TheLabBeginsWhenAllWhoAreExpectedAreReady) {
  EXPECT_EQ((Names{"/bridge", "/robot"}), members_.unready());
  members_.note({"/bridge", Stage::First, 0, true, false}, 0.0);
  members_.note({"/robot", Stage::Second, 0, false, false}, 0.0);
  EXPECT_EQ(Names{"/robot"}, members_.unready());
  members_.note({"/robot", Stage::Second, 0, true, false}, 0.1);
  EXPECT_EQ(Names{}, members_.unready());
  members_.note({"/mission", Stage::StartOnly, 0, false, false}, 0.1);
  EXPECT_EQ(Names{"/mission"}, members_.unready());
}

TEST_F(LockStepMembersTest, WaitsForTheStageThatWasCalled) {
  answer("/bridge", Stage::First, 0, 0.0);
  answer("/robot", Stage::Second, 0, 0.0);
  answer("/mission", Stage::StartOnly, 0, 0.0);
  members_.call(Stage::First, 1, 0.0);
  EXPECT_FALSE(members_.hasAnswered());
  answer("/robot", Stage::Second, 1, 0.1);
  EXPECT_FALSE(members_.hasAnswered());
  answer("/bridge", Stage::First, 1, 0.1);
  EXPECT_TRUE(members_.hasAnswered());
  members_.call(Stage::Second, 1, 0.1);
  EXPECT_TRUE(members_.hasAnswered());
  members_.call(Stage::Second, 2, 0.2);
  EXPECT_FALSE(members_.hasAnswered());
}

TEST_F(LockStepMembersTest, TellsOfASilentNodeOnceAndGoesOnWithoutIt) {
  answer("/robot", Stage::Second, 0, 0.0);
  members_.call(Stage::Second, 1, 10.0);
  EXPECT_EQ(Names{}, members_.findSilent(10.0 + kLimit_s));
  EXPECT_EQ(Names{"/robot"}, members_.findSilent(10.1 + kLimit_s));
  EXPECT_TRUE(members_.hasAnswered());
  EXPECT_EQ(Names{}, members_.findSilent(20.0));
  members_.call(Stage::Second, 2, 20.0);
  EXPECT_TRUE(members_.hasAnswered());
  const LockStepMembers::Return back =
      members_.note({"/robot", Stage::Second, 2, true, false}, 25.0);
  EXPECT_TRUE(back.is_new);
  EXPECT_DOUBLE_EQ(25.0, back.silent_s);
  members_.call(Stage::Second, 3, 25.0);
  EXPECT_FALSE(members_.hasAnswered());
}

TEST_F(LockStepMembersTest, NobodyWaitsForANodeThatHasEnded) {
  answer("/bridge", Stage::First, 0, 0.0);
  answer("/robot", Stage::Second, 0, 0.0);
  members_.call(Stage::Second, 1, 0.0);
  members_.leave("/robot");
  EXPECT_TRUE(members_.hasAnswered());
  EXPECT_EQ(Names{}, members_.silent());
  EXPECT_EQ(Names{"/robot"}, members_.unready());
  EXPECT_TRUE(members_.note({"/robot", Stage::Second, 1, true, false}, 1.0).is_new);
}

TEST_F(LockStepMembersTest, ABusyNodeIsWaitedForAsLongAsItSaysSo) {
  answer("/planner", Stage::Second, 0, 0.0);
  members_.call(Stage::Second, 1, 0.0);
  for (double wall_s = 0.0; wall_s < 10.0; wall_s += 1.0) {
    members_.note({"/planner", Stage::Second, 1, true, true}, wall_s);
    EXPECT_EQ(Names{}, members_.findSilent(wall_s + 0.9));
    EXPECT_FALSE(members_.hasAnswered());
  }
  EXPECT_EQ(Names{"/planner"}, members_.findSilent(9.1 + kLimit_s));
}

}  // namespace
