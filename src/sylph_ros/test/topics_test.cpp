#include "sylph_ros/topics.hpp"

#include <gtest/gtest.h>
#include <ros/init.h>

namespace sylph_ros {
namespace {

TEST(TopicsTest, AFleetIsAroundTheNamespaceOfItsNodes) {
  const ros::NodeHandle suite("/lab/sylph");
  EXPECT_EQ("/lab/map", fleetName(suite, kMapTopic));
  EXPECT_EQ("/lab/cf1/pose", robotTopic(suite, "cf1", kPoseTopic));
  EXPECT_EQ("/lab/sylph", suiteHandle(ros::NodeHandle("/lab/cf1")).getNamespace());
}

TEST(TopicsTest, WithoutANamespaceAFleetIsAtTheRoot) {
  const ros::NodeHandle suite("/sylph");
  EXPECT_EQ("/map", fleetName(suite, kMapTopic));
  EXPECT_EQ("/robot_3/task", robotTopic(suite, "robot_3", kTaskTopic));
  EXPECT_EQ("/sylph", suiteHandle(ros::NodeHandle("/robot_3")).getNamespace());
  EXPECT_EQ("/robot_3/task", robotTopic(ros::NodeHandle("/"), "robot_3", kTaskTopic));
}

}  // namespace
}  // namespace sylph_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "topics_test");
  return RUN_ALL_TESTS();
}
