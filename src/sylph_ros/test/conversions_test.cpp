#include "sylph_ros/conversions.hpp"

#include <gtest/gtest.h>
#include <sylph_msgs/AgentAction.h>

namespace sylph_ros {
namespace {

TEST(ConversionsTest, CellThereAndBackIsTheIdentity) {
  const sylph::Cell cell{-3, 7};
  EXPECT_EQ(cell, fromMessage(toMessage(cell)));
}

TEST(ConversionsTest, ActionsHaveTheValuesOfTheMessage) {
  using sylph_msgs::AgentAction;
  EXPECT_EQ(AgentAction::STAY, toMessage(sylph::Action::Stay));
  EXPECT_EQ(AgentAction::NORTH, toMessage(sylph::Action::North));
  EXPECT_EQ(AgentAction::EAST, toMessage(sylph::Action::East));
  EXPECT_EQ(AgentAction::SOUTH, toMessage(sylph::Action::South));
  EXPECT_EQ(AgentAction::WEST, toMessage(sylph::Action::West));
  for (const sylph::Action action : sylph::kActions) {
    EXPECT_EQ(action, actionFromMessage(toMessage(action)));
  }
  EXPECT_FALSE(actionFromMessage(5).has_value());
}

TEST(ConversionsTest, YawThereAndBackIsTheIdentity) {
  for (double yaw_rad = -3.1; yaw_rad < 3.14; yaw_rad += 0.1) {
    EXPECT_NEAR(yaw_rad, yawOf(quaternionFromYaw(yaw_rad)), 1e-12);
  }
}

}  // namespace
}  // namespace sylph_ros
