#include "sylph_robot_node/conversions.hpp"

#include <gtest/gtest.h>

namespace sylph_robot_node {
namespace {

TEST(ConversionsTest, ATwistIsInTheBaseFrame) {
  const geometry_msgs::Twist message = toMessage(sylph::Twist2d{0.1, -0.2, 0.3});
  EXPECT_DOUBLE_EQ(0.1, message.linear.x);
  EXPECT_DOUBLE_EQ(-0.2, message.linear.y);
  EXPECT_DOUBLE_EQ(0.3, message.angular.z);
}

}  // namespace
}  // namespace sylph_robot_node
