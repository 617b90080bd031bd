#include "sylph_adg_central/condition_log.hpp"

#include <gtest/gtest.h>

namespace sylph_adg_central {
namespace {

using sylph::RobotCondition;
using Lines = std::vector<std::string>;

constexpr double kLater_s = 100.0;

class ConditionLogTest : public testing::Test {
 protected:
  ConditionLog log_{{"robot_0", "robot_1"}};
};

TEST_F(ConditionLogTest, TellsOfAConditionAtOnceAndLaterHowLongItWas) {
  EXPECT_EQ("robot_1 is blind: no good pose",
            log_.note(1, RobotCondition::Blind, "no good pose", 10.0));
  EXPECT_EQ(Lines{}, log_.takeSettled(kLater_s));
  EXPECT_FALSE(log_.note(1, RobotCondition::Ok, "", 100.5));
  EXPECT_EQ(Lines{}, log_.takeSettled(100.6));
  EXPECT_EQ(Lines{"robot_1 was blind for 90.5 s"},
            log_.takeSettled(100.5 + ConditionLog::kSettled_s));
  EXPECT_EQ(Lines{}, log_.takeSettled(2 * kLater_s));
}

TEST_F(ConditionLogTest, WhatComesAndGoesIsToldOnce) {
  EXPECT_TRUE(log_.note(0, RobotCondition::Blind, "", 10.0));
  for (double now_s = 11.0; now_s < 15.5; now_s += 1.0) {
    EXPECT_FALSE(log_.note(0, RobotCondition::Ok, "", now_s - 0.75));
    EXPECT_EQ(Lines{}, log_.takeSettled(now_s));
    EXPECT_FALSE(log_.note(0, RobotCondition::Blind, "", now_s));
  }
  EXPECT_FALSE(log_.note(0, RobotCondition::Ok, "", 15.5));
  EXPECT_EQ(Lines{"robot_0 was blind 6 times within 5.5 s, 1.8 s in all"},
            log_.takeSettled(kLater_s));
  EXPECT_EQ("robot_0 is blind", log_.note(0, RobotCondition::Blind, "", kLater_s));
}

TEST_F(ConditionLogTest, OneConditionEndsAnother) {
  EXPECT_EQ("robot_0 is blind", log_.note(0, RobotCondition::Blind, "", 10.0));
  EXPECT_EQ("robot_1 is stuck", log_.note(1, RobotCondition::Stuck, "", 10.0));
  EXPECT_EQ("robot_0 is silent", log_.note(0, RobotCondition::Silent, "", 11.0));
  EXPECT_FALSE(log_.note(0, RobotCondition::Silent, "", 12.0));
  EXPECT_EQ((Lines{"robot_0 has been silent for 2.0 s", "robot_0 was blind for 1.0 s",
                   "robot_1 has been stuck for 3.0 s"}),
            log_.takeAll(13.0));
  EXPECT_EQ(Lines{}, log_.takeAll(14.0));
}

}  // namespace
}  // namespace sylph_adg_central
