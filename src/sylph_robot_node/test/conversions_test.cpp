#include "sylph_robot_node/conversions.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "sylph_ros/conversions.hpp"

namespace sylph_robot_node {
namespace {

TEST(ConversionsTest, APoseKeepsPositionAndYaw) {
  geometry_msgs::Pose message;
  message.position.x = 1.5;
  message.position.y = -0.5;
  message.orientation = sylph_ros::quaternionFromYaw(2.0);
  const sylph::Pose2d pose = fromMessage(message);
  EXPECT_DOUBLE_EQ(1.5, pose.x_m);
  EXPECT_DOUBLE_EQ(-0.5, pose.y_m);
  EXPECT_NEAR(2.0, pose.yaw_rad, 1e-12);
}

TEST(ConversionsTest, APoseWithoutARotationIsNotFinite) {
  geometry_msgs::Pose message;  // all zeros
  EXPECT_FALSE(sylph::isFinite(fromMessage(message)));
  message.orientation.w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(sylph::isFinite(fromMessage(message)));
}

TEST(ConversionsTest, ATwistIsInTheBaseFrame) {
  const geometry_msgs::Twist message = toMessage(sylph::Twist2d{0.1, -0.2, 0.3});
  EXPECT_DOUBLE_EQ(0.1, message.linear.x);
  EXPECT_DOUBLE_EQ(-0.2, message.linear.y);
  EXPECT_DOUBLE_EQ(0.3, message.angular.z);
}

}  // namespace
}  // namespace sylph_robot_node
