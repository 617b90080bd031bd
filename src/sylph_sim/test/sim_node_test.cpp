#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sylph_msgs/InjectFault.h>
#include <sylph_msgs/SimulationTruth.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "sylph_natnet/frame_codec.hpp"
#include "sylph_natnet/model_codec.hpp"
#include "sylph_natnet/udp_socket.hpp"
#include "sylph_ros/topics.hpp"
#include "sylph_ros/wait_until.hpp"

/// The simulator as its users see it: two robots, see two_robots.yaml, at four times real time.
namespace sylph_sim {
namespace {

using sylph_natnet::MessageId;

const sylph_natnet::Endpoint kServer{{127, 0, 0, 1}, 21510};
const sylph_natnet::Version kVersion{4, 1};

class SimNodeTest : public testing::Test {
 protected:
  SimNodeTest() {
    truth_subscriber_ = nh_.subscribe<sylph_msgs::SimulationTruth>(
        sylph_ros::kSimulationTruthTopic, 1,
        [this](const sylph_msgs::SimulationTruthConstPtr& message) { truth_ = *message; });
    commands_ = {nh_.advertise<geometry_msgs::Twist>("/robot_0/cmd_vel", 1),
                 nh_.advertise<geometry_msgs::Twist>("/robot_1/cmd_vel", 1)};
  }

  /// Handles messages until the condition holds.
  /// @return whether it does before 20 s of wall time have passed
  static bool waitUntil(const std::function<bool()>& condition) {
    return sylph_ros::waitUntil(
        condition, [] { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01)); });
  }

  /// Commands one robot until the condition holds, then stops it.
  bool driveUntil(std::size_t robot, double x_mps, const std::function<bool()>& condition) {
    geometry_msgs::Twist command;
    command.linear.x = x_mps;
    const bool holds = waitUntil([&] {
      commands_[robot].publish(command);
      return condition();
    });
    commands_[robot].publish(geometry_msgs::Twist());
    return holds;
  }

  bool hasTruth() {
    return waitUntil([this] { return truth_.has_value(); });
  }

  ros::NodeHandle nh_;
  ros::Subscriber truth_subscriber_;
  std::vector<ros::Publisher> commands_;
  std::optional<sylph_msgs::SimulationTruth> truth_;
};

/// Just enough of a client: asks, and takes the first answer with the id asked for.
class NatNetProbe {
 public:
  NatNetProbe() : socket_(sylph_natnet::Endpoint{{127, 0, 0, 1}, 0}) {
    socket_.sendTo(sylph_natnet::makeConnect("test", kVersion), kServer);
  }

  template <typename Parse>
  auto next(MessageId id, Parse parse)
      -> std::optional<decltype(parse(sylph_natnet::ByteReader(nullptr, 0)))> {
    sylph_natnet::Datagram datagram;
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(20.0);
    while (ros::WallTime::now() < deadline) {
      sylph_natnet::waitForInput({&socket_}, std::chrono::milliseconds(100));
      while (socket_.receive(datagram)) {
        const sylph_natnet::Message message = sylph_natnet::openMessage(datagram);
        if (message.id == id) {
          return parse(message.payload);
        }
      }
    }
    return std::nullopt;
  }

  std::optional<sylph_natnet::Frame> nextFrame() {
    return next(MessageId::FrameOfData,
                [](auto payload) { return sylph_natnet::parseFrame(payload, kVersion); });
  }

  std::optional<sylph_natnet::ModelDefinitions> definitions() {
    socket_.sendTo(sylph_natnet::makeModelDefinitionsRequest(false), kServer);
    return next(MessageId::ModelDefinitions, [](auto payload) {
      return sylph_natnet::parseModelDefinitions(payload, kVersion);
    });
  }

 private:
  sylph_natnet::UdpSocket socket_;
};

TEST_F(SimNodeTest, TheClockRunsForwardFromAboutNow) {
  std::vector<double> times_s;
  const ros::Subscriber subscriber = nh_.subscribe<rosgraph_msgs::Clock>(
      "/clock", 100, [&times_s](const rosgraph_msgs::ClockConstPtr& message) {
        times_s.push_back(message->clock.toSec());
      });
  ASSERT_TRUE(waitUntil([&times_s] { return times_s.size() >= 100; }));
  EXPECT_TRUE(std::is_sorted(times_s.begin(), times_s.end()));
  EXPECT_GE(times_s.back() - times_s.front(), 0.5);
  EXPECT_LT(std::abs(times_s.front() - ros::WallTime::now().toSec()), 3600.0);
}

TEST_F(SimNodeTest, RobotsStartInTheirCellsAndMoveAsCommanded) {
  ASSERT_TRUE(hasTruth());
  EXPECT_EQ("map", truth_->header.frame_id);
  ASSERT_EQ((std::vector<std::string>{"robot_0", "robot_1"}), truth_->robots);
  EXPECT_NEAR(0.15, truth_->poses[0].x, 0.01);
  EXPECT_NEAR(0.45, truth_->poses[0].y, 0.01);
  const double y_m = truth_->poses[1].y;
  ASSERT_TRUE(driveUntil(1, 0.2, [this] { return truth_->poses[1].x > 1.35; }));
  ASSERT_TRUE(driveUntil(1, -0.2, [this] { return truth_->poses[1].x < 1.1; }));
  EXPECT_NEAR(0.15, truth_->poses[0].x, 0.01);
  EXPECT_NEAR(y_m, truth_->poses[1].y, 0.1);
  EXPECT_EQ(0U, truth_->collisions);
  EXPECT_EQ(0U, truth_->obstacle_entries);
}

TEST_F(SimNodeTest, TheCamerasShowTheRobotsByName) {
  ASSERT_TRUE(hasTruth());
  NatNetProbe probe;
  const auto definitions = probe.definitions();
  ASSERT_TRUE(definitions.has_value());
  ASSERT_EQ(2U, definitions->rigid_bodies.size());
  EXPECT_EQ("body_b", definitions->rigid_bodies[1].name);
  const auto frame = probe.nextFrame();
  ASSERT_TRUE(frame.has_value());
  ASSERT_EQ(2U, frame->rigid_bodies.size());
  EXPECT_EQ(definitions->rigid_bodies[0].id, frame->rigid_bodies[0].id);
  // y up, as the launch file says.
  EXPECT_NEAR(truth_->poses[0].x, frame->rigid_bodies[0].position_m[0], 0.01);
  EXPECT_NEAR(-truth_->poses[0].y, frame->rigid_bodies[0].position_m[2], 0.01);
  EXPECT_TRUE(frame->rigid_bodies[0].tracked);
  EXPECT_GT(frame->transmit_ticks, frame->mid_exposure_ticks);
}

TEST_F(SimNodeTest, AnInjectedFaultShowsAndEnds) {
  ASSERT_TRUE(hasTruth());
  sylph_msgs::InjectFault fault;
  fault.request.kind = "lost";
  fault.request.robots = {"robot_1"};
  fault.request.duration_s = 2.0;
  ASSERT_TRUE(ros::service::call(nh_.resolveName(sylph_ros::kInjectFaultService), fault));
  ASSERT_TRUE(fault.response.success) << fault.response.message;
  NatNetProbe probe;
  const auto isTracked = [&probe](std::size_t body) {
    const auto frame = probe.nextFrame();
    return frame && frame->rigid_bodies.at(body).tracked;
  };
  ASSERT_TRUE(waitUntil([&] { return !isTracked(1); }));
  EXPECT_TRUE(isTracked(0));
  EXPECT_TRUE(waitUntil([&] { return isTracked(1); }));
  EXPECT_TRUE(waitUntil([this] { return truth_->active_faults == 0; }));
}

TEST_F(SimNodeTest, ABadFaultIsRefusedWithItsReason) {
  sylph_msgs::InjectFault fault;
  fault.request.kind = "lost";
  fault.request.robots = {"robot_9"};
  ASSERT_TRUE(ros::service::call(nh_.resolveName(sylph_ros::kInjectFaultService), fault));
  EXPECT_FALSE(fault.response.success);
  EXPECT_NE(std::string::npos, fault.response.message.find("robot_9"));
}

TEST_F(SimNodeTest, TellsItsSpeedInDiagnostics) {
  bool is_told = false;
  const ros::Subscriber subscriber = nh_.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&is_told](const diagnostic_msgs::DiagnosticArrayConstPtr& message) {
        for (const auto& value : message->status.at(0).values) {
          is_told = is_told || value.key == "speed asked for";
        }
      });
  EXPECT_TRUE(waitUntil([&is_told] { return is_told; }));
}

// The last one: robots stay in contact.
TEST_F(SimNodeTest, TheTruthCountsAStagedCollision) {
  ASSERT_TRUE(hasTruth());
  EXPECT_EQ(0U, truth_->collisions);
  ASSERT_TRUE(driveUntil(0, 0.2, [this] { return truth_->collisions > 0; }));
  EXPECT_EQ(1U, truth_->collisions);
  EXPECT_EQ(0.0, truth_->min_separation_m);
}

}  // namespace
}  // namespace sylph_sim

int main(int argc, char** argv) {
  ros::init(argc, argv, "sim_node_test");
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
