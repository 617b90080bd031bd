#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sys/wait.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "bridge_world.hpp"
#include "sylph_mocap_bridge/pose_topics_input.hpp"
#include "sylph_ros/conversions.hpp"

namespace sylph_mocap_bridge {
namespace {

using geometry_msgs::PoseStamped;
using test::Recorder;
using test::waitUntil;

constexpr double kSpeedMps = 0.2;

/// Two bodies in Z-up axes: the first drives along x with its heading at 90 degrees, the second
/// stands.
sylph_natnet::Frame zUpFrame(double time_s) {
  sylph_natnet::Frame frame;
  frame.rigid_bodies.resize(2);
  frame.rigid_bodies[0].id = 11;
  frame.rigid_bodies[0].position_m = {static_cast<float>(kSpeedMps * (time_s - 1000.0)), 1.0F,
                                      0.12F};
  frame.rigid_bodies[0].orientation_xyzw = {0.0F, 0.0F, std::sqrt(0.5F), std::sqrt(0.5F)};
  frame.rigid_bodies[1].id = 12;
  frame.rigid_bodies[1].position_m = {0.5F, -0.25F, 0.12F};
  return frame;
}

/// The same in Y-up axes.
sylph_natnet::Frame yUpFrame(double time_s) {
  sylph_natnet::Frame frame = zUpFrame(time_s);
  for (sylph_natnet::RigidBodySample& body : frame.rigid_bodies) {
    const auto p = body.position_m;
    const auto q = body.orientation_xyzw;
    body.position_m = {p[0], p[2], -p[1]};
    body.orientation_xyzw = {q[0], q[2], -q[1], q[3]};
  }
  return frame;
}

class MocapBridgeNodeTest : public testing::Test {
 protected:
  MocapBridgeNodeTest()
      : parameters_(testing::UnitTest::GetInstance()->current_test_info()->name()) {
    parameters_.set("frozen_limit_s", 0.0);  // these cameras have no noise
    spinner_.start();
  }

  void startServer(const test::StreamingServer::FrameSource& source,
                   sylph_natnet::ServerOptions options = {}, double begin_s = 1000.0) {
    options.command_port = command_port_;
    options.data_port = 0;
    server_ = std::make_unique<test::StreamingServer>(options, source, 1.0, begin_s);
    server_->setDefinitions(test::definitionsOf({"red", "blue car"}));
    command_port_ = server_->commandPort();
  }

  void startNode() {
    if (command_port_ != 0) {
      parameters_.set("command_port", static_cast<int>(command_port_));
    }
    node_ = std::make_unique<MocapBridgeNode>(ros::NodeHandle(), parameters_.handle());
  }

  static void expectSecondRobotStands(const PoseStamped& pose) {
    EXPECT_EQ("map", pose.header.frame_id);
    EXPECT_NEAR(0.5, pose.pose.position.x, 1e-6);
    EXPECT_NEAR(-0.25, pose.pose.position.y, 1e-6);
    EXPECT_NEAR(0.12, pose.pose.position.z, 1e-6);
    EXPECT_NEAR(0.0, sylph_ros::yawOf(pose.pose.orientation), 1e-6);
  }

  ros::AsyncSpinner spinner_{2};
  test::NodeParameters parameters_;
  std::uint16_t command_port_ = 0;
  std::unique_ptr<test::StreamingServer> server_;
  std::unique_ptr<MocapBridgeNode> node_;
  Recorder<PoseStamped> first_{"/robot_0/pose"};
  Recorder<PoseStamped> second_{"/robot_1/pose"};
};

TEST_F(MocapBridgeNodeTest, PosesArriveInTheMapFromZUpAxes) {
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(second_.waitForMore(20));
  expectSecondRobotStands(second_.messages().back());
  ASSERT_TRUE(first_.waitForMore(1));
  EXPECT_NEAR(M_PI_2, sylph_ros::yawOf(first_.messages().back().pose.orientation), 1e-6);
}

TEST_F(MocapBridgeNodeTest, PosesArriveInTheMapFromYUpAxes) {
  parameters_.set("up_axis", "y");
  startServer(yUpFrame);
  startNode();
  ASSERT_TRUE(second_.waitForMore(20));
  expectSecondRobotStands(second_.messages().back());
  ASSERT_TRUE(first_.waitForMore(1));
  EXPECT_NEAR(1.0, first_.messages().back().pose.position.y, 1e-6);
  EXPECT_NEAR(M_PI_2, sylph_ros::yawOf(first_.messages().back().pose.orientation), 1e-6);
}

TEST_F(MocapBridgeNodeTest, CalibrationIsApplied) {
  parameters_.set("map_from_mocap/x_m", 2.0);
  parameters_.set("body_from_robot/robot_1/yaw_rad", 0.3);
  parameters_.set("body_from_robot/robot_1/x_m", 0.01);
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(second_.waitForMore(1));
  EXPECT_NEAR(2.51, second_.messages().back().pose.position.x, 1e-6);
  EXPECT_NEAR(0.3, sylph_ros::yawOf(second_.messages().back().pose.orientation), 1e-6);
}

TEST_F(MocapBridgeNodeTest, StampsAreThoseOfTheExposureInOrderAndEven) {
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(first_.waitForMore(200));
  const std::vector<PoseStamped> poses = first_.messages();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double step_s = (poses[i].header.stamp - poses[i - 1].header.stamp).toSec();
    ASSERT_GT(step_s, 0.0);
    // Whole periods, as frames that wait are passed over.
    const double periods = step_s * 120.0;
    ASSERT_NEAR(std::round(periods), periods, 0.05);
    // The position tells the server's time of sending, 5 ms after the exposure.
    const double moved_m = poses[i].pose.position.x - poses[i - 1].pose.position.x;
    ASSERT_NEAR(kSpeedMps * step_s, moved_m, 1e-4);
  }
  EXPECT_LT(std::abs((ros::Time::now() - poses.back().header.stamp).toSec()), 1.0);
}

TEST_F(MocapBridgeNodeTest, OdometryHasTheVelocityInTheRobotsFrame) {
  Recorder<nav_msgs::Odometry> odometry("/robot_0/odom");
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(odometry.waitForMore(60));
  const nav_msgs::Odometry message = odometry.messages().back();
  EXPECT_EQ("map", message.header.frame_id);
  EXPECT_EQ("robot_0", message.child_frame_id);
  // It drives along the map's x, which is to the right of a robot that looks along y.
  EXPECT_NEAR(0.0, message.twist.twist.linear.x, 0.01);
  EXPECT_NEAR(-kSpeedMps, message.twist.twist.linear.y, 0.01);
  EXPECT_NEAR(0.0, message.twist.twist.angular.z, 0.01);
  EXPECT_GT(message.twist.covariance[0], 0.0);
  EXPECT_LT(message.twist.covariance[0], 0.01);
}

TEST_F(MocapBridgeNodeTest, OneTfMessageHasAllRobotsAndIsDecimated) {
  Recorder<tf2_msgs::TFMessage> tf("/tf");
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(tf.waitForMore(30));
  const tf2_msgs::TFMessage message = tf.messages().back();
  ASSERT_EQ(2U, message.transforms.size());
  EXPECT_EQ("map", message.transforms[1].header.frame_id);
  EXPECT_EQ("robot_1", message.transforms[1].child_frame_id);
  EXPECT_NEAR(0.5, message.transforms[1].transform.translation.x, 1e-6);
  EXPECT_LT(tf.count(), first_.count());
}

TEST_F(MocapBridgeNodeTest, ALostBodyHasNoPoseAndComesBack) {
  enum Fault { None, Untracked, NaN, Zero };
  std::atomic<int> fault{None};
  startServer([&fault](double time_s) {
    sylph_natnet::Frame frame = zUpFrame(time_s);
    sylph_natnet::RigidBodySample& body = frame.rigid_bodies[1];
    body.tracked = fault != Untracked;
    if (fault == NaN) {
      body.position_m.fill(std::numeric_limits<float>::quiet_NaN());
    } else if (fault == Zero) {
      body.position_m.fill(0.0F);
      body.orientation_xyzw.fill(0.0F);
    }
    return frame;
  });
  startNode();
  for (const Fault kind : {Untracked, NaN, Zero}) {
    fault = None;
    ASSERT_TRUE(second_.waitForMore(5));
    fault = kind;
    ASSERT_TRUE(first_.waitForMore(20));  // what was on its way has come
    const std::size_t before = second_.count();
    ASSERT_TRUE(first_.waitForMore(40));
    EXPECT_EQ(before, second_.count()) << "fault " << kind;
  }
  for (const PoseStamped& pose : second_.messages()) {
    expectSecondRobotStands(pose);
  }
}

TEST_F(MocapBridgeNodeTest, AFrozenBodyHasNoPose) {
  parameters_.set("frozen_limit_s", 0.1);
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(first_.waitForMore(60));
  EXPECT_LT(second_.count(), 30U);
}

TEST_F(MocapBridgeNodeTest, GoesOnAfterARestartOfTheServer) {
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(second_.waitForMore(5));
  server_.reset();
  second_.clear();
  sylph_natnet::ServerOptions restarted;
  restarted.version = {3, 0};
  restarted.ticks_per_s = 3'300'000;
  startServer(zUpFrame, restarted, 7.0);
  ASSERT_TRUE(second_.waitForMore(20));
  expectSecondRobotStands(second_.messages().back());
}

TEST_F(MocapBridgeNodeTest, FollowsNamesThatChange) {
  startServer(zUpFrame);
  startNode();
  ASSERT_TRUE(second_.waitForMore(5));
  server_->setDefinitions(test::definitionsOf({"red", "lamp"}));
  ASSERT_TRUE(waitUntil([this] {
    const std::size_t before = second_.count();
    first_.waitForMore(20);
    return second_.count() == before;
  }));
  // Now the standing body is robot_0.
  server_->setDefinitions(test::definitionsOf({"lamp", "red"}));
  ASSERT_TRUE(waitUntil([this] {
    first_.waitForMore(1);
    return std::abs(first_.messages().back().pose.position.y + 0.25) < 1e-6;
  }));
}

TEST_F(MocapBridgeNodeTest, ReceivesMulticast) {
  sylph_natnet::ServerOptions options;
  options.multicast = true;
  options.multicast_group = {239, 255, 42, 96};
  startServer(zUpFrame, options);
  parameters_.set("transport", "multicast");
  parameters_.set("multicast_group", "239.255.42.96");
  parameters_.set("data_port", static_cast<int>(server_->dataPort()));
  startNode();
  ASSERT_TRUE(second_.waitForMore(5));
  expectSecondRobotStands(second_.messages().back());
}

TEST_F(MocapBridgeNodeTest, TakesPosesFromTopics) {
  parameters_.set("input", "pose_topics");
  parameters_.set("pose_topic", "/driver/{rigid_body}/pose");
  startNode();
  ros::NodeHandle nh;
  ros::Publisher driver = nh.advertise<PoseStamped>("/driver/bluecar/pose", 1);
  PoseStamped pose;
  pose.header.frame_id = "world";
  pose.pose.position.x = 0.5;
  pose.pose.position.y = -0.25;
  pose.pose.position.z = 0.12;
  pose.pose.orientation.w = 1.0;
  ASSERT_TRUE(waitUntil([&] {
    pose.header.stamp = ros::Time::now();
    driver.publish(pose);
    return second_.count() > 0;
  }));
  expectSecondRobotStands(second_.messages().back());
  const ros::Time last = second_.messages().back().header.stamp;
  // No number, old, twice: none of them gets through.
  PoseStamped bad = pose;
  bad.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  bad.header.stamp = ros::Time::now();
  driver.publish(bad);
  bad = pose;
  bad.header.stamp = last;
  driver.publish(bad);
  second_.clear();
  ASSERT_TRUE(waitUntil([&] {
    pose.header.stamp = ros::Time::now();
    driver.publish(pose);
    return second_.count() > 0;
  }));
  for (const PoseStamped& message : second_.messages()) {
    EXPECT_GT(message.header.stamp, last);
    EXPECT_TRUE(std::isfinite(message.pose.position.x));
  }
}

/// @return the newest message of a diagnostic of that name
std::string summaryOf(const Recorder<diagnostic_msgs::DiagnosticArray>& diagnostics,
                      const std::string& name) {
  std::string text;
  for (const diagnostic_msgs::DiagnosticArray& array : diagnostics.messages()) {
    for (const diagnostic_msgs::DiagnosticStatus& status : array.status) {
      if (status.name.find(name) != std::string::npos) {
        text = status.message;
      }
    }
  }
  return text;
}

TEST_F(MocapBridgeNodeTest, NamesAllPoseTopicsThatLack) {
  Recorder<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  parameters_.set("input", "pose_topics");
  startNode();
  // Its own topics of poses are none of the driver's.
  EXPECT_TRUE(waitUntil([&] {
    return summaryOf(diagnostics, "link") ==
           "nobody publishes /vrpn_client_node/red/pose, /vrpn_client_node/bluecar/pose: there is "
           "no topic of poses at all, is the driver running?";
  })) << summaryOf(diagnostics, "link");
}

TEST_F(MocapBridgeNodeTest, TwoBodiesOfOneTopicAreRefused) {
  struct : MeasurementSink {
    void onMeasurements(const std::vector<Measurement>& /*unused*/, double /*unused*/) override {}
    void onRestart() override {}
  } sink;
  std::vector<sylph::RobotSpec> robots(2);
  robots[0].name = "left";
  robots[0].rigid_body = "Rigid Body 1";
  robots[1].name = "right";
  robots[1].rigid_body = "RigidBody-1";
  ros::NodeHandle nh;
  try {
    const PoseTopicsInput input(nh, "/vrpn/{rigid_body}/pose", StampPolicy::Receive, robots, sink);
    FAIL() << "two robots follow one body";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        "robots left and right would both follow /vrpn/RigidBody1/pose: give their rigid bodies "
        "names that differ in letters or digits",
        error.what());
  }
}

TEST_F(MocapBridgeNodeTest, DiagnosticsTellWhatIsWrong) {
  Recorder<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  const auto linkSays = [&diagnostics](const std::string& part) {
    return waitUntil(
        [&] { return summaryOf(diagnostics, "link").find(part) != std::string::npos; });
  };
  startServer(zUpFrame);
  server_.reset();
  startNode();
  EXPECT_TRUE(linkSays("no answer from 127.0.0.1"));
  EXPECT_TRUE(waitUntil([&] {
    return summaryOf(diagnostics, "bodies").find("robot_1 is not seen") != std::string::npos;
  }));
  startServer(zUpFrame);
  EXPECT_TRUE(linkSays("all bodies are known"));
  EXPECT_TRUE(waitUntil([&] { return summaryOf(diagnostics, "bodies") == "all bodies are seen"; }));
  server_->setDefinitions(test::definitionsOf({"red", "red"}));
  EXPECT_TRUE(linkSays("more than one rigid body is called red"));
}

TEST_F(MocapBridgeNodeTest, AWrongBitstreamGivesNoPosesAndIsNamed) {
  Recorder<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  parameters_.set("bitstream", "2.9");
  sylph_natnet::ServerOptions options;
  options.version = {2, 11};
  startServer(zUpFrame, options);
  startNode();
  EXPECT_TRUE(waitUntil([&] {
    return summaryOf(diagnostics, "link") ==
           "data are not what bitstream 2.9 says (frame: 4 bytes are left behind its end): the "
           "server says that it streams 2.11: leave bitstream empty";
  })) << summaryOf(diagnostics, "link");
  EXPECT_EQ(0U, first_.count());
}

TEST_F(MocapBridgeNodeTest, ABitstreamNeedsNoQuotes) {
  parameters_.set("bitstream", 3.0);
  sylph_natnet::ServerOptions options;
  options.version = {3, 0};
  startServer(zUpFrame, options);
  startNode();
  EXPECT_TRUE(second_.waitForMore(5));
}

TEST_F(MocapBridgeNodeTest, EachBadParameterIsRefusedByName) {
  // An unknown group is named, not what is in it.
  const auto refuses = [](const std::string& name, const auto& value,
                          const std::string& named = "") {
    test::NodeParameters parameters("bad_parameters");
    parameters.set(name, value);
    try {
      const MocapBridgeNode node(ros::NodeHandle(), parameters.handle());
      return false;
    } catch (const std::exception& error) {
      return std::string(error.what()).find(named.empty() ? name : named) != std::string::npos &&
             std::string(error.what()).find('\n') == std::string::npos;
    }
  };
  EXPECT_TRUE(refuses("input", "vicon"));
  EXPECT_TRUE(refuses("server_address", "no.such.host.invalid"));
  EXPECT_TRUE(refuses("server_address", true));
  EXPECT_TRUE(refuses("local_interface", "no.such.host.invalid"));
  EXPECT_TRUE(refuses("command_port", 0));
  EXPECT_TRUE(refuses("data_port", 65536));
  EXPECT_TRUE(refuses("transport", "broadcast"));
  EXPECT_TRUE(refuses("multicast_group", "192.168.1.1"));
  EXPECT_TRUE(refuses("bitstream", "1.0"));
  EXPECT_TRUE(refuses("pose_topic", "/pose"));
  EXPECT_TRUE(refuses("stamp", "now"));
  EXPECT_TRUE(refuses("up_axis", "x"));
  EXPECT_TRUE(refuses("map_from_mocap", 1.0));
  EXPECT_TRUE(refuses("map_from_mocap/z_m", 1.0));
  EXPECT_TRUE(refuses("map_from_mocap/x_m", "far"));
  EXPECT_TRUE(refuses("body_from_robot/robot_9/x_m", 0.1, "body_from_robot/robot_9"));
  EXPECT_TRUE(refuses("body_from_robot/robot_1/yaw_deg", 90.0));
  EXPECT_TRUE(refuses("largest_age_s", 0.0));
  EXPECT_TRUE(refuses("frozen_limit_s", -0.1));
  EXPECT_TRUE(refuses("position_sigma_m", -1.0));
  EXPECT_TRUE(refuses("tf_rate_hz", -1.0));
  EXPECT_TRUE(refuses("servre_address", "127.0.0.1"));
}

TEST_F(MocapBridgeNodeTest, TheProgramExitsOnABadParameter) {
  const int status = std::system(MOCAP_BRIDGE_PROGRAM " __name:=refused _input:=vicon");
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(EXIT_FAILURE, WEXITSTATUS(status));
}

}  // namespace
}  // namespace sylph_mocap_bridge

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mocap_bridge_node_test");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
