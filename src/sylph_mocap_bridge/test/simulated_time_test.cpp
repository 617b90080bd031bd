#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>

#include <cmath>

#include "bridge_world.hpp"

namespace sylph_mocap_bridge {
namespace {

using geometry_msgs::PoseStamped;

constexpr double kSpeed = 8.0;
constexpr double kClockStepS = 0.02;
constexpr double kRosBeginS = 100.0;

/// A body whose height tells the time.
sylph_natnet::Frame frameAt(double time_s) {
  sylph_natnet::Frame frame;
  frame.rigid_bodies.resize(1);
  frame.rigid_bodies[0].id = 11;
  frame.rigid_bodies[0].position_m = {0.0F, 0.0F, static_cast<float>(time_s - 1000.0)};
  return frame;
}

/// Simulated time eight times as fast as the wall, published in steps.
class SimulatedTimeTest : public testing::Test {
 protected:
  SimulatedTimeTest() : parameters_("bridge") {
    server_.setDefinitions(test::definitionsOf({"red"}));
    parameters_.set("command_port", static_cast<int>(server_.commandPort()));
    node_ = std::make_unique<MocapBridgeNode>(ros::NodeHandle(), parameters_.handle());
    ros::NodeHandle nh;
    clock_ = nh.advertise<rosgraph_msgs::Clock>("/clock", 1);
    timer_ = nh.createSteadyTimer(ros::WallDuration(kClockStepS / kSpeed),
                                  [this](const ros::SteadyTimerEvent&) { publishClock(); });
    spinner_.start();
  }
  ~SimulatedTimeTest() override { spinner_.stop(); }

  void publishClock() {
    rosgraph_msgs::Clock message;
    const double since_start_s = server_.now_s() - 1000.0;
    message.clock.fromSec(kRosBeginS - set_back_s_ +
                          std::floor(since_start_s / kClockStepS) * kClockStepS);
    clock_.publish(message);
  }

  static sylph_natnet::ServerOptions anyPort() {
    sylph_natnet::ServerOptions options;
    options.command_port = 0;
    options.data_port = 0;
    return options;
  }

  ros::AsyncSpinner spinner_{2};
  test::NodeParameters parameters_;
  test::StreamingServer server_{anyPort(), frameAt, kSpeed};
  std::atomic<double> set_back_s_{0.0};
  std::unique_ptr<MocapBridgeNode> node_;
  test::Recorder<PoseStamped> poses_{"/robot_0/pose"};
  ros::Publisher clock_;
  ros::SteadyTimer timer_;
};

TEST_F(SimulatedTimeTest, StampsAreSmoothAlthoughTheClockMovesInSteps) {
  ASSERT_TRUE(poses_.waitForMore(1000));
  const std::vector<PoseStamped> poses = poses_.messages();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double step_s = (poses[i].header.stamp - poses[i - 1].header.stamp).toSec();
    const double truth_s = poses[i].pose.position.z - poses[i - 1].pose.position.z;
    ASSERT_GT(step_s, 0.0);
    // The offset may slew by 2 ms a second, and a float tells the time to 1e-6 or so.
    ASSERT_NEAR(truth_s, step_s, 0.003 * truth_s + 1e-4) << i;
  }
  // Exposure is 5 ms before sending, which is the time that the height tells. The clock's steps and
  // what a busy machine adds lie within some tens of milliseconds.
  const double truth_s = kRosBeginS + poses.back().pose.position.z - 0.005;
  EXPECT_NEAR(truth_s, poses.back().header.stamp.toSec(), 0.2);
}

TEST_F(SimulatedTimeTest, GoesOnWhenTheClockIsSetBack) {
  ASSERT_TRUE(poses_.waitForMore(200));
  const ros::Time before = poses_.messages().back().header.stamp;
  set_back_s_ = 60.0;
  ASSERT_TRUE(test::waitUntil([&] { return poses_.messages().back().header.stamp < before; }));
  EXPECT_TRUE(poses_.waitForMore(200));
}

}  // namespace
}  // namespace sylph_mocap_bridge

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulated_time_test");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
