#include "sylph_sim/fault.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sylph_sim {
namespace {

Fault fault(FaultKind kind, std::vector<std::size_t> robots, double at_s, double duration_s) {
  return {kind, std::move(robots), at_s, duration_s, defaultValue(kind)};
}

TEST(FaultKindTest, NamesThereAndBack) {
  for (const char* name : {"stuck", "slow", "dead", "deaf", "drift", "lost", "nan", "frozen",
                           "yaw_flip", "jump", "swap", "silent"}) {
    EXPECT_EQ(name, toName(faultKindFromName(name)));
  }
}

TEST(FaultKindTest, AnUnknownNameIsAnErrorThatListsTheKnown) {
  try {
    faultKindFromName("stcuk");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("stcuk"));
    EXPECT_NE(std::string::npos, std::string(error.what()).find("stuck"));
  }
}

TEST(FaultScriptTest, AFaultHoldsFromItsStartToBeforeItsEnd) {
  FaultScript script(2);
  script.add(fault(FaultKind::Lost, {1}, 2.0, 0.5), 10.0);
  EXPECT_FALSE(script.stateAt(11.99).robots[1].capture.is_lost);
  EXPECT_TRUE(script.stateAt(12.0).robots[1].capture.is_lost);
  EXPECT_TRUE(script.stateAt(12.49).robots[1].capture.is_lost);
  EXPECT_FALSE(script.stateAt(12.5).robots[1].capture.is_lost);
  EXPECT_FALSE(script.stateAt(12.2).robots[0].capture.is_lost);
  EXPECT_EQ(1U, script.activeCount(12.2));
  EXPECT_EQ(0U, script.activeCount(12.5));
}

TEST(FaultScriptTest, NoRobotNamedMeansAll) {
  FaultScript script(3);
  script.add(fault(FaultKind::Lost, {}, 0.0, 1.0), 0.0);
  for (const RobotFault& robot : script.stateAt(0.5).robots) {
    EXPECT_TRUE(robot.capture.is_lost);
  }
}

TEST(FaultScriptTest, EachKindChangesItsOwnMember) {
  FaultScript script(12);
  std::size_t robot = 0;
  for (const FaultKind kind :
       {FaultKind::Stuck, FaultKind::Slow, FaultKind::Dead, FaultKind::Deaf, FaultKind::Drift,
        FaultKind::Nan, FaultKind::Frozen, FaultKind::YawFlip, FaultKind::Jump}) {
    script.add(fault(kind, {robot++}, 0.0, 1.0), 0.0);
  }
  script.add(fault(FaultKind::Swap, {9, 10}, 0.0, 1.0), 0.0);
  script.add(fault(FaultKind::Silent, {}, 0.0, 1.0), 0.0);
  const FaultState state = script.stateAt(0.5);
  EXPECT_EQ(0.0, state.robots[0].base.speed_factor);
  EXPECT_EQ(0.2, state.robots[1].base.speed_factor);
  EXPECT_TRUE(state.robots[2].base.is_dead);
  EXPECT_TRUE(state.robots[3].is_deaf);
  EXPECT_EQ(0.05, state.robots[4].base.drift_mps);
  EXPECT_TRUE(state.robots[5].capture.is_nan);
  EXPECT_TRUE(state.robots[6].capture.is_frozen);
  EXPECT_NEAR(M_PI, state.robots[7].capture.yaw_offset_rad, 1e-12);
  EXPECT_EQ(0.1, state.robots[8].capture.x_offset_m);
  EXPECT_EQ(10U, state.robots[9].capture.shown_robot);
  EXPECT_EQ(9U, state.robots[10].capture.shown_robot);
  EXPECT_TRUE(state.is_silent);
  const RobotFault& untouched = state.robots[11];
  EXPECT_EQ(1.0, untouched.base.speed_factor);
  EXPECT_FALSE(untouched.base.is_dead || untouched.is_deaf);
  EXPECT_FALSE(untouched.capture.is_lost || untouched.capture.is_nan ||
               untouched.capture.is_frozen);
  EXPECT_EQ(11U, untouched.capture.shown_robot);
}

TEST(FaultScriptTest, ADeadRobotStaysDead) {
  FaultScript script(1);
  script.add(fault(FaultKind::Dead, {0}, 0.0, 1.0), 0.0);
  EXPECT_TRUE(script.stateAt(1e6).robots[0].base.is_dead);
}

TEST(FaultScriptTest, RefusesWhatMakesNoSense) {
  FaultScript script(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(script.add(fault(FaultKind::Lost, {2}, 0.0, 1.0), 0.0), std::invalid_argument);
  EXPECT_THROW(script.add(fault(FaultKind::Lost, {0}, -1.0, 1.0), 0.0), std::invalid_argument);
  EXPECT_THROW(script.add(fault(FaultKind::Lost, {0}, 0.0, 0.0), 0.0), std::invalid_argument);
  EXPECT_THROW(script.add(fault(FaultKind::Lost, {0}, 0.0, nan), 0.0), std::invalid_argument);
  EXPECT_THROW(script.add(fault(FaultKind::Swap, {0}, 0.0, 1.0), 0.0), std::invalid_argument);
  EXPECT_THROW(script.add(fault(FaultKind::Swap, {1, 1}, 0.0, 1.0), 0.0), std::invalid_argument);
  EXPECT_THROW(script.add({FaultKind::Slow, {0}, 0.0, 1.0, -1.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(script.add({FaultKind::Jump, {0}, 0.0, 1.0, nan}, 0.0), std::invalid_argument);
  EXPECT_THROW(FaultScript(0), std::invalid_argument);
  EXPECT_EQ(0U, script.activeCount(0.0));
}

}  // namespace
}  // namespace sylph_sim
