#pragma once

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <sylph_msgs/ExecuteMissionAction.h>

#include <cstdint>
#include <functional>
#include <future>
#include <stdexcept>
#include <string>

#include "mission/small_lab.hpp"
#include "mock_central.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_planner_node {

using sylph_ros::waitUntil;

/// Asks a node to shut down, as `rosnode kill` does.
inline bool shutDown(const std::string& node) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue payload;
  request[0] = ros::this_node::getName();
  request[1] = node;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, payload, false) ||
      !ros::network::splitURI(payload, host, port)) {
    return false;
  }
  request[1] = "asked for by a test";
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  return client.execute("shutdown", request, response);
}

/// What `run` throws in a thread of its own, "none" if nothing; `meanwhile` is called beside it.
template <typename Run>
std::string failureOf(Run run, const std::function<void()>& meanwhile) {
  auto outcome = std::async(std::launch::async, run);
  meanwhile();
  try {
    outcome.get();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

/// The node under test runs beside this program; central node, robots and motion capture are mocks.
class PlannerFixture : public testing::Test {
 protected:
  using Client = actionlib::SimpleActionClient<sylph_msgs::ExecuteMissionAction>;

  void SetUp() override {
    ASSERT_TRUE(waitUntil([this] { return client_.isServerConnected(); }));
  }

  sylph_msgs::ExecuteMissionResult run(const sylph_msgs::ExecuteMissionGoal& goal) {
    client_.sendGoal(goal);
    return waitForResult();
  }

  sylph_msgs::ExecuteMissionResult waitForResult() {
    EXPECT_TRUE(waitUntil([this] { return client_.getState().isDone(); }));
    const auto result = client_.getResult();
    return result ? *result : sylph_msgs::ExecuteMissionResult();
  }

  bool waitForPhase(std::uint8_t phase) {
    return waitUntil([&] { return central_.state().phase == phase; });
  }

  /// The node under test has read its parameters anew when this returns, as after a crash.
  bool startPlannerAgain() {
    return shutDown("/sylph/sylph_planner") &&
           waitUntil([this] { return !client_.isServerConnected(); }) &&
           waitUntil([this] { return client_.isServerConnected(); });
  }

  MockCentral central_{sylph::smallMission(), sylph::smallStarts()};
  Client client_{"/sylph/execute_mission", true};
};

}  // namespace sylph_planner_node
