#include "sylph_ros/measured_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sylph_ros/conversions.hpp"

namespace sylph_ros {
namespace {

geometry_msgs::PoseStamped goodPose() {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = "map";
  message.pose.position.x = 1.5;
  message.pose.position.y = -0.5;
  message.pose.orientation = quaternionFromYaw(2.0);
  return message;
}

TEST(JudgePoseTest, AGoodPoseKeepsPositionAndYaw) {
  const JudgedPose judged = judgePose(goodPose(), 0.3, 0.5);
  EXPECT_EQ(PoseFault::None, judged.fault);
  EXPECT_EQ("", judged.reason);
  EXPECT_DOUBLE_EQ(1.5, judged.pose.x_m);
  EXPECT_DOUBLE_EQ(-0.5, judged.pose.y_m);
  EXPECT_NEAR(2.0, judged.pose.yaw_rad, 1e-12);
}

TEST(JudgePoseTest, AQuaternionThatIsNoRotationIsAFault) {
  geometry_msgs::PoseStamped message = goodPose();
  message.pose.orientation = geometry_msgs::Quaternion();  // all zeros
  const JudgedPose judged = judgePose(message);
  EXPECT_EQ(PoseFault::NoRotation, judged.fault);
  EXPECT_EQ("has a quaternion of length 0.00: it must be 1", judged.reason);
  EXPECT_FALSE(sylph::isFinite(judged.pose));
  message.pose.orientation.w = 0.5;
  EXPECT_EQ(PoseFault::NoRotation, judgePose(message).fault);
}

TEST(JudgePoseTest, NumbersThatAreNoneAreAFault) {
  geometry_msgs::PoseStamped message = goodPose();
  message.pose.position.y = std::nan("");
  EXPECT_EQ(PoseFault::NotFinite, judgePose(message).fault);
  EXPECT_EQ("is not a number", judgePose(message).reason);
  message = goodPose();
  message.pose.orientation.w = std::nan("");
  EXPECT_EQ(PoseFault::NotFinite, judgePose(message).fault);
}

TEST(JudgePoseTest, AnotherFrameIsAFault) {
  geometry_msgs::PoseStamped message = goodPose();
  message.header.frame_id = "optitrack";
  const JudgedPose judged = judgePose(message);
  EXPECT_EQ(PoseFault::Frame, judged.fault);
  EXPECT_EQ("is in frame 'optitrack': it must be 'map'", judged.reason);
}

TEST(JudgePoseTest, AnOldPoseIsAFault) {
  const JudgedPose judged = judgePose(goodPose(), 0.8, 0.5);
  EXPECT_EQ(PoseFault::Old, judged.fault);
  EXPECT_EQ("came 0.80 s ago: at most 0.50 s are allowed", judged.reason);
  EXPECT_EQ(PoseFault::Old, judgePose(goodPose(), std::nan(""), 0.5).fault);
}

}  // namespace
}  // namespace sylph_ros
