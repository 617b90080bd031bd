#include "sylph_mocap_bridge/conversions.hpp"

#include <gtest/gtest.h>

#include "sylph_mocap_bridge/pose_topics_input.hpp"

namespace sylph_mocap_bridge {
namespace {

ReliablePose examplePose() {
  ReliablePose pose;
  pose.stamp_s = 12.5;
  pose.map_from_robot = toPose({1.0, 2.0, M_PI_2});
  pose.velocity = Velocity{0.25, 0.0, 0.1, 1e-4, 1e-3};
  return pose;
}

TEST(ConversionsTest, PoseIsInTheMapAndStamped) {
  const geometry_msgs::PoseStamped message = toPoseStamped(examplePose());
  EXPECT_EQ("map", message.header.frame_id);
  EXPECT_EQ(ros::Time(12, 500000000), message.header.stamp);
  EXPECT_EQ(2.0, message.pose.position.y);
  EXPECT_NEAR(std::sqrt(0.5), message.pose.orientation.z, 1e-12);
}

TEST(ConversionsTest, TransformLeadsFromMapToRobot) {
  const geometry_msgs::TransformStamped message = toTransform(examplePose(), "robot_3");
  EXPECT_EQ("map", message.header.frame_id);
  EXPECT_EQ("robot_3", message.child_frame_id);
  EXPECT_EQ(1.0, message.transform.translation.x);
}

TEST(ConversionsTest, TwistIsInTheRobotsFrame) {
  TrackerOptions noise;
  const nav_msgs::Odometry message = toOdometry(examplePose(), "robot_3", noise);
  EXPECT_EQ("robot_3", message.child_frame_id);
  EXPECT_NEAR(0.0, message.twist.twist.linear.x, 1e-12);
  EXPECT_NEAR(-0.25, message.twist.twist.linear.y, 1e-12);
  EXPECT_EQ(0.1, message.twist.twist.angular.z);
  EXPECT_EQ(1e-4, message.twist.covariance[7]);
  EXPECT_EQ(1e-3, message.twist.covariance[35]);
  EXPECT_GT(message.twist.covariance[14], 1e3);
  EXPECT_DOUBLE_EQ(noise.position_sigma_m * noise.position_sigma_m, message.pose.covariance[0]);
}

TEST(ConversionsTest, TopicNamesAreCleaned) {
  sylph::RobotSpec robot;
  robot.name = "robot_3";
  const auto topicOf = [&robot](const std::string& rigid_body) {
    robot.rigid_body = rigid_body;
    return poseTopic("/vrpn_client_node/{rigid_body}/pose", robot);
  };
  // As vrpn_client_ros 0.2.2 cleans them.
  EXPECT_EQ("/vrpn_client_node/RigidBody1/pose", topicOf("Rigid Body 1"));
  EXPECT_EQ("/vrpn_client_node/bluecar2/pose", topicOf("blue car-2"));
  EXPECT_EQ("/vrpn_client_node/fleet/red_1/pose", topicOf("fleet/red_1"));
  EXPECT_EQ("/vrpn_client_node/2red/pose", topicOf("12red"));
  EXPECT_EQ("/vrpn_client_node/x/pose", topicOf("_x"));
  EXPECT_EQ("/vrpn_client_node/Rob/pose", topicOf("R\xC3\xB6"
                                                  "ob"));
  EXPECT_THROW(topicOf("7"), std::runtime_error);
  EXPECT_THROW(topicOf("\xE7\xBA\xA2"), std::runtime_error);
  EXPECT_EQ("/robot_3/raw/robot_3", poseTopic("/{robot}/raw/{robot}", robot));
}

}  // namespace
}  // namespace sylph_mocap_bridge
