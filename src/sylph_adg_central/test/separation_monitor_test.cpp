#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <std_msgs/Bool.h>
#include <sylph_msgs/SeparationState.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>

#include "sylph_adg_central/separation_monitor_node.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_adg_central {
namespace {

class SeparationMonitorTest : public testing::Test {
 protected:
  SeparationMonitorTest() : node_(nh_, ros::NodeHandle("~")) {
    for (const char* robot : {"robot_0", "robot_1"}) {
      publishers_.push_back(nh_.advertise<geometry_msgs::PoseStamped>(
          sylph_ros::robotTopic(nh_, robot, sylph_ros::kPoseTopic), 10));
    }
    subscribers_.push_back(nh_.subscribe<sylph_msgs::SeparationState>(
        sylph_ros::kSeparationTopic, 10,
        [this](const sylph_msgs::SeparationState::ConstPtr& state) { state_ = *state; }));
    subscribers_.push_back(nh_.subscribe<std_msgs::Bool>(
        sylph_ros::kEmergencyStopTopic, 10,
        [this](const std_msgs::Bool::ConstPtr& stop) { is_stopped_ = stop->data != 0; }));
    const bool is_up = spinUntil([&] {
      return publishers_[0].getNumSubscribers() == 1 && publishers_[1].getNumSubscribers() == 1 &&
             is_stopped_.has_value();
    });
    EXPECT_TRUE(is_up);
  }

  /// Robot 1 stands `gap_m` in front of robot 0; both report so until the condition holds.
  bool spinUntil(const std::function<bool()>& condition) {
    return sylph_ros::waitUntil(condition, [this] {
      publish(0, 1.0);
      publish(1, 1.0 + 0.23 + gap_m_);
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    });
  }

  void publish(std::size_t robot, double x_m) {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = frame_id_;
    pose.header.stamp = ros::Time::now();
    pose.pose.position.x = x_m;
    if (has_rotation_) {
      pose.pose.orientation = sylph_ros::quaternionFromYaw(0.0);
    }
    publishers_[robot].publish(pose);
  }

  std_srvs::Trigger::Response reset() {
    std_srvs::Trigger trigger;
    std::atomic<bool> is_over{false};
    std::thread caller([&] {
      ros::service::call(nh_.resolveName(sylph_ros::kSeparationResetService), trigger);
      is_over = true;
    });
    spinUntil([&] { return is_over.load(); });
    caller.join();
    return trigger.response;
  }

  ros::NodeHandle nh_;
  SeparationMonitorNode node_;
  std::vector<ros::Publisher> publishers_;
  std::vector<ros::Subscriber> subscribers_;
  sylph_msgs::SeparationState state_;
  std::optional<bool> is_stopped_;
  std::string frame_id_ = "map";
  bool has_rotation_ = true;
  double gap_m_ = 0.07;
};

TEST_F(SeparationMonitorTest, StopsAllUntilItIsResetWithRoomAgain) {
  ASSERT_TRUE(spinUntil([&] { return std::abs(state_.separation_m - 0.07) < 1e-6; }));
  EXPECT_EQ("map", state_.header.frame_id);
  EXPECT_FALSE(state_.header.stamp.isZero());
  EXPECT_EQ("robot_0", state_.robot_a);
  EXPECT_EQ("robot_1", state_.robot_b);
  EXPECT_EQ(std::vector<std::string>{"robot_2"}, state_.without_pose);
  EXPECT_NEAR(0.0052, state_.limit_m, 1e-4) << "half of what the margin promises";
  EXPECT_FALSE(*is_stopped_);

  gap_m_ = 0.003;
  ASSERT_TRUE(spinUntil([&] { return *is_stopped_ && state_.violated != 0; }));
  EXPECT_NEAR(0.003, state_.min_separation_m, 1e-6);
  const auto refused = reset();
  EXPECT_EQ(0, refused.success);
  EXPECT_EQ("robot_0 and robot_1 are 3.0 mm apart: move them apart first", refused.message);

  gap_m_ = 0.07;
  ASSERT_TRUE(spinUntil([&] { return std::abs(state_.separation_m - 0.07) < 1e-6; }));
  EXPECT_TRUE(*is_stopped_) << "room alone releases nobody";
  EXPECT_EQ(1, reset().success);
  EXPECT_TRUE(spinUntil([&] { return !*is_stopped_ && state_.violated == 0; }));
}

TEST_F(SeparationMonitorTest, IgnoresPosesOfAnotherFrame) {
  ASSERT_TRUE(spinUntil([&] { return std::abs(state_.separation_m - 0.07) < 1e-6; }));
  frame_id_ = "mocap";
  gap_m_ = 0.001;
  ASSERT_TRUE(spinUntil([&] { return state_.without_pose.size() == 3; }));
  EXPECT_FALSE(*is_stopped_);
  EXPECT_NEAR(0.07, state_.separation_m, 1e-6);
}

TEST_F(SeparationMonitorTest, APoseWithoutARotationIsNone) {
  ASSERT_TRUE(spinUntil([&] { return std::abs(state_.separation_m - 0.07) < 1e-6; }));
  has_rotation_ = false;
  gap_m_ = 0.001;
  ASSERT_TRUE(spinUntil([&] { return state_.without_pose.size() == 3; }));
  EXPECT_FALSE(*is_stopped_);
  EXPECT_NEAR(0.07, state_.separation_m, 1e-6);
}

}  // namespace
}  // namespace sylph_adg_central

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "separation_monitor_test");
  const ros::NodeHandle keep_ros_running;
  return RUN_ALL_TESTS();
}
