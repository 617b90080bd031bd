#pragma once

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <sylph_msgs/ExecuteMissionAction.h>

#include "mission/small_lab.hpp"
#include "mock_central.hpp"
#include "sylph_ros/wait_until.hpp"

namespace sylph_planner_node {

using sylph_ros::waitUntil;

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

  MockCentral central_{sylph::smallMission(), sylph::smallStarts()};
  Client client_{"/sylph/execute_mission", true};
};

}  // namespace sylph_planner_node
