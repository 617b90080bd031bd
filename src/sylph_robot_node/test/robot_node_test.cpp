#include <XmlRpcClient.h>
#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/TaskReport.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>
#include <utility>

#include "mock_lab.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_robot_node {
namespace {

using sylph_msgs::AdgState;
using sylph_msgs::TaskReport;
using sylph_ros::waitUntil;

double speedOf(const geometry_msgs::Twist& command) {
  return std::hypot(command.linear.x, command.linear.y);
}

/// Process id of a running node, -1 if it cannot be asked.
int processOf(const std::string& node) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, uri, false) ||
      !ros::network::splitURI(static_cast<std::string>(uri), host, port)) {
    return -1;
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue who;
  who[0] = ros::this_node::getName();
  return client.execute("getPid", who, response) ? static_cast<int>(response[2]) : -1;
}

/// Exit status of a shell command and what it says until it ends.
std::pair<int, std::string> outcomeOf(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    return {-1, "did not start"};
  }
  std::string said;
  std::array<char, 512> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    said += buffer.data();
  }
  return {WEXITSTATUS(pclose(pipe)), said};
}

std::pair<int, std::string> confirmPose(const std::string& arguments) {
  return outcomeOf("env ROS_NAMESPACE=/ " SYLPH_CONFIRM_POSE_EXECUTABLE " " + arguments);
}

/// Confirms the pose of a robot that was moved by hand.
void expectConfirmed(MockLab& lab) {
  lab.setMode(AdgState::STOP);
  const int stops = lab.stateCount() + 3;
  ASSERT_TRUE(waitUntil([&] { return lab.stateCount() > stops; }));
  const auto [status, said] = confirmPose("robot_0");
  EXPECT_EQ(0, status) << said;
  EXPECT_EQ(0U, said.find("robot_0: its pose is confirmed: ")) << said;
  lab.setMode(AdgState::RUN);
}

void expectBelievedOnlyWhenConfirmed(MockLab& lab, double offset_m) {
  SCOPED_TRACE(offset_m);
  lab.setCameraOffset(offset_m);
  ASSERT_TRUE(
      waitUntil([&] { return lab.report().detail.find("confirm its pose") != std::string::npos; }));
  EXPECT_EQ(std::make_pair(1, std::string("sylph_confirm_pose: robot_0: stop first: a robot whose "
                                          "pose is confirmed may drive on at once\n")),
            confirmPose("robot_0"));
  expectConfirmed(lab);
  ASSERT_TRUE(waitUntil([&] { return lab.report().state == TaskReport::IDLE; }));
}

void expectTurnsBackWhenToldToAlign(MockLab& lab) {
  lab.turn(0.44);
  ASSERT_TRUE(
      waitUntil([&] { return lab.report().detail.find("confirm its pose") != std::string::npos; }));
  expectConfirmed(lab);
  ASSERT_TRUE(
      waitUntil([&] { return lab.report().detail == "heading is 25 deg off: turn it by hand"; }));
  lab.setAligning(true);
  ASSERT_TRUE(waitUntil([&] { return std::abs(lab.pose().yaw_rad) < 0.05; }));
  ASSERT_TRUE(waitUntil([&] { return lab.report().state == TaskReport::IDLE; }));
  lab.setAligning(false);
}

void expectZerosAfterTheKill(MockLab& lab, int process) {
  lab.sendTask(2, 0, {0, 3}, {1, 3});
  ASSERT_TRUE(waitUntil([&] { return speedOf(lab.command()) > 0.1; }));
  ASSERT_EQ(0, kill(process, SIGINT));
  ASSERT_TRUE(waitUntil([&] { return speedOf(lab.command()) == 0.0; }));
  const std::size_t commands = lab.commandCount();
  ASSERT_TRUE(waitUntil([&] { return !lab.hasCommander(); }));
  EXPECT_GT(lab.commandCount(), commands + 5);
  EXPECT_DOUBLE_EQ(0.0, speedOf(lab.command()));
}

// One story in order: the node lives through all of it.
TEST(RobotNodeTest, ATaskFromHoldToShutdown) {
  MockLab lab({0, 0});
  ASSERT_TRUE(waitUntil([&] { return lab.isConnected(); }));

  // It sends zeros all the time, and does not move before the central node is heard.
  ASSERT_TRUE(waitUntil([&] { return lab.commandCount() > 20 && lab.report().pose_age_s < 0.1; }));
  lab.sendTask(1, 0, {0, 0}, {0, 1});
  ASSERT_TRUE(waitUntil([&] { return lab.report().state == TaskReport::HOLDING; }));
  EXPECT_EQ("central node not heard yet", lab.report().detail);
  EXPECT_EQ(1U, lab.report().accepted);
  EXPECT_DOUBLE_EQ(0.0, speedOf(lab.command()));

  // Then it drives, and tells of its arrival.
  lab.setCentral(true);
  ASSERT_TRUE(waitUntil([&] { return lab.report().done == 1; }));
  EXPECT_EQ(1U, lab.report().plan_id);
  EXPECT_EQ("robot_0", lab.report().robot_id);
  EXPECT_EQ("map", lab.report().header.frame_id);
  EXPECT_FALSE(lab.report().header.stamp.isZero());
  EXPECT_NEAR(0.45, lab.pose().x_m, 0.012);
  EXPECT_NEAR(0.75, lab.pose().y_m, 0.012);

  // The same task again and one of another map change nothing.
  lab.sendTask(1, 0, {0, 0}, {0, 1});
  lab.sendTask(1, 1, {0, 1}, {1, 1});  // an obstacle
  lab.sendTask(1, 2, {0, 2}, {0, 3});  // behind a gap
  lab.sendTask(1, 1, {0, 1}, {0, 2});
  ASSERT_TRUE(waitUntil([&] { return lab.report().accepted == 3; }));
  ASSERT_TRUE(waitUntil([&] { return speedOf(lab.command()) > 0.15; }));

  // Blind without poses; goes on by itself.
  lab.setCameras(false);
  ASSERT_TRUE(waitUntil([&] { return lab.report().state == TaskReport::BLIND; }));
  ASSERT_TRUE(waitUntil([&] { return speedOf(lab.command()) == 0.0; }));
  lab.setCameras(true);
  ASSERT_TRUE(waitUntil([&] { return lab.report().state == TaskReport::MOVING; }));

  // An emergency stop holds until the central node was stopped and resumed.
  lab.setEmergency(true);
  ASSERT_TRUE(waitUntil([&] { return lab.report().state == TaskReport::HOLDING; }));
  EXPECT_EQ("emergency stop", lab.report().detail);
  lab.setMode(AdgState::STOP);
  const int stops = lab.stateCount() + 3;
  ASSERT_TRUE(waitUntil([&] { return lab.stateCount() > stops; }));
  lab.setEmergency(false);
  EXPECT_DOUBLE_EQ(0.0, speedOf(lab.command()));
  lab.setMode(AdgState::RUN);
  ASSERT_TRUE(waitUntil([&] { return lab.report().done == 3; }));
  EXPECT_NEAR(1.05, lab.pose().x_m, 0.012);

  // Seen at another place, it believes the operator's word for it, and back again.
  expectBelievedOnlyWhenConfirmed(lab, 0.08);
  expectBelievedOnlyWhenConfirmed(lab, 0.0);
  expectTurnsBackWhenToldToAlign(lab);
  EXPECT_EQ(1, confirmPose("robot_7").first);
  EXPECT_EQ(1, confirmPose("").first);

  // A second node of the same name leaves it alone and says so, once.
  const int process = processOf("/robot_0/sylph_robot");
  ASSERT_GT(process, 0);
  const std::string said = outcomeOf("timeout 5 " SYLPH_ROBOT_EXECUTABLE " __ns:=robot_0").second;
  EXPECT_NE(std::string::npos, said.find("/robot_0/sylph_robot already runs at http://")) << said;
  EXPECT_EQ(1, std::count(said.begin(), said.end(), '\n')) << said;
  EXPECT_EQ(process, processOf("/robot_0/sylph_robot"));

  // Killed while it drives, it leaves zeros behind.
  expectZerosAfterTheKill(lab, process);
}

}  // namespace
}  // namespace sylph_robot_node

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "robot_node_test");
  ros::start();
  return RUN_ALL_TESTS();
}
