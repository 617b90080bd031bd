#include "sylph_rviz/markers_node.hpp"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <functional>
#include <map>

#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"
#include "test_scene.hpp"

namespace sylph_rviz {
namespace {

/// The node in a namespace of its own, fed by the test, and a picture as RViz would keep it.
class MarkersNodeTest : public ::testing::Test {
 protected:
  void SetUp() override {
    state_ = suite_.advertise<sylph_msgs::AdgState>(sylph_ros::kAdgStateTopic, 1, true);
    pose_ = suite_.advertise<geometry_msgs::PoseStamped>("/robot_0/pose", 1, true);
    map_ = suite_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
    const Scene scene = twoRobots();
    state_.publish(*scene.state);
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = "map";
    pose.pose.orientation.w = 1.0;
    pose_.publish(pose);
    nav_msgs::OccupancyGrid map;
    map.info.width = 5;
    map.info.height = 4;
    map.info.resolution = 0.3F;
    map_.publish(map);
  }

  void look(const std::string& layer) {
    shown_.clear();
    subscriber_ = suite_.subscribe<visualization_msgs::MarkerArray>(
        layer, 10, [this](const visualization_msgs::MarkerArray::ConstPtr& message) {
          for (const Marker& marker : message->markers) {
            take(marker);
          }
        });
  }

  void take(const Marker& marker) {
    if (marker.action == Marker::DELETEALL) {
      shown_.clear();
    } else if (marker.action == Marker::DELETE) {
      shown_.erase(marker.ns + std::to_string(marker.id));
    } else {
      shown_[marker.ns + std::to_string(marker.id)] = marker;
    }
  }

  static bool waitUntil(const std::function<bool()>& condition) {
    return sylph_ros::waitUntil(
        condition, [] { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05)); });
  }

  ros::NodeHandle suite_{"sylph"};
  ros::Publisher state_;
  ros::Publisher pose_;
  ros::Publisher map_;
  ros::Subscriber subscriber_;
  std::map<std::string, Marker> shown_;
};

TEST_F(MarkersNodeTest, DrawsRobotsThatItKnowsFromTopicsAlone) {
  const MarkersNode node(suite_, ros::NodeHandle("shipped"));
  look("markers/robots");
  EXPECT_TRUE(waitUntil([&] { return shown_.count("body0") == 1; }));
  EXPECT_EQ("robot_0", shown_["body0"].header.frame_id);
  EXPECT_EQ(0U, shown_.count("body1")) << "robot_1 has no pose";
}

TEST_F(MarkersNodeTest, ALayerThatIsSwitchedOffAndOnComesBack) {
  const MarkersNode node(suite_, ros::NodeHandle("shipped"));
  look("markers/svo");
  ASSERT_TRUE(waitUntil([&] { return shown_.count("value0") == 1; }));
  subscriber_.shutdown();
  look("markers/svo");
  EXPECT_TRUE(waitUntil([&] { return shown_.count("value0") == 1; }));
}

TEST_F(MarkersNodeTest, ANamespaceThatWasClearedComesBackWithoutSubscribingAgain) {
  const MarkersNode node(suite_, ros::NodeHandle("shipped"));
  look("markers/svo");
  ASSERT_TRUE(waitUntil([&] { return shown_.count("value0") == 1; }));
  shown_.clear();
  EXPECT_TRUE(waitUntil([&] { return shown_.count("value0") == 1; }));
}

TEST_F(MarkersNodeTest, TakesFootprintsFromTopicsWithoutAnExperiment) {
  const MarkersNode node(suite_, ros::NodeHandle("shipped"));
  look("markers/robots");
  RobotView robot;
  robot.name = "robot_0";
  robot.length_m = 0.6;
  robot.width_m = 0.4;
  ros::Publisher footprint =
      suite_.advertise<geometry_msgs::PolygonStamped>("/robot_0/footprint", 1, true);
  footprint.publish(footprintOf(robot));
  EXPECT_TRUE(waitUntil([&] { return std::abs(shown_["body0"].scale.x - 0.6) < 1e-6; }));
}

TEST_F(MarkersNodeTest, PublishesFootprintsOfItsExperiment) {
  const MarkersNode node(ros::NodeHandle("fleet/sylph"), ros::NodeHandle("shipped"));
  double length_m = 0.0;
  const ros::Subscriber footprint = suite_.subscribe<geometry_msgs::PolygonStamped>(
      "/fleet/alpha/footprint", 1, [&](const geometry_msgs::PolygonStamped::ConstPtr& message) {
        RobotView robot;
        robot.length_m = 0.0;
        setFootprint(robot, *message);
        length_m = robot.length_m;
      });
  EXPECT_TRUE(waitUntil([&] { return std::abs(length_m - 0.21) < 1e-6; }));
}

TEST_F(MarkersNodeTest, DropsAPoseThatIsNotFinite) {
  const MarkersNode node(suite_, ros::NodeHandle("shipped"));
  look("markers/robots");
  ASSERT_TRUE(waitUntil([&] { return shown_.count("body0") == 1; }));
  geometry_msgs::PoseStamped bad;
  bad.header.frame_id = "map";
  bad.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  pose_.publish(bad);
  // While the central node goes on, its last good pose grows old: the robot is drawn faint.
  EXPECT_TRUE(waitUntil([&] {
    state_.publish(*twoRobots().state);
    return shown_["body0"].color.a < 0.9F;
  }));
}

TEST_F(MarkersNodeTest, DrawsNobodyFaintWhenAReplayIsPaused) {
  const MarkersNode node(suite_, ros::NodeHandle("shipped"));
  look("markers/robots");
  ASSERT_TRUE(waitUntil([&] { return shown_.count("body0") == 1; }));
  const ros::SteadyTime longer_than_the_limit = ros::SteadyTime::now() + ros::WallDuration(1.0);
  bool was_faint = false;
  ASSERT_TRUE(waitUntil([&] {
    was_faint = was_faint || shown_["body0"].color.a < 0.9F;
    return ros::SteadyTime::now() > longer_than_the_limit;
  }));
  EXPECT_FALSE(was_faint);
}

TEST(MarkersNodeStartTest, RefusesEachBadParameter) {
  for (const char* ns : {"bad_rate", "bad_lifetime", "bad_timeout", "bad_name", "bad_type"}) {
    EXPECT_THROW(MarkersNode(ros::NodeHandle("sylph"), ros::NodeHandle(ns)), std::runtime_error)
        << ns;
  }
  EXPECT_THROW(MarkersNode(ros::NodeHandle("bad_fleet/sylph"), ros::NodeHandle("shipped")),
               std::runtime_error);
}

}  // namespace
}  // namespace sylph_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "markers_node_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
