#pragma once

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/RobotExecution.h>
#include <sys/wait.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "mock_robot.hpp"
#include "sylph_adg_central/central_node.hpp"
#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/plan_messages.hpp"

namespace sylph_adg_central {

using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

/// A plan as its planner sends it; every robot's partner is the first one.
inline sylph_msgs::JointActions jointActions(const sylph::Plan& plan,
                                             const std::vector<std::string>& robots,
                                             std::uint32_t plan_id,
                                             std::uint32_t replaces_plan_id = 0) {
  sylph::MissionPlan mission;
  mission.plan_id = plan_id;
  mission.replaces_plan_id = replaces_plan_id;
  mission.planner = "test";
  mission.planning_s = 0.5;
  mission.robots = robots;
  mission.goals = plan.back();
  mission.plan = plan;
  const std::vector<sylph::AgentId> partners(robots.size(), 0);
  mission.social.assign(mission.steps(), {partners, std::vector<float>(robots.size(), 15.0F)});
  return sylph_ros::toMessage(mission);
}

/// Three robots: robot_0 follows robot_1 along the top row, robot_2 crosses behind them.
inline sylph::Plan mission() {
  return {{{0, 0}, {0, 1}, {3, 3}}, {{0, 1}, {0, 2}, {3, 3}}, {{0, 2}, {0, 3}, {3, 3}},
          {{0, 3}, {0, 4}, {2, 3}}, {{0, 4}, {0, 5}, {1, 3}}, {{0, 4}, {0, 5}, {0, 3}}};
}

/// A central node with three robots that step from task to task, and a planner and an operator.
class CentralNodeTest : public testing::Test {
 protected:
  CentralNodeTest() : private_nh_("~"), frame_(5, 0.3) {
    folder_ = testing::TempDir() + "sylph_" + std::to_string(ros::WallTime::now().toNSec());
    nh_.setParam("run_folder", folder_);
    private_nh_.setParam("lost_after_s", 0.0);
    private_nh_.setParam("silent_after_s", 1.0);
    private_nh_.setParam("stuck_after_s", 5.0);
    publisher_ = nh_.advertise<sylph_msgs::JointActions>(sylph_ros::kJointActionsTopic, 1, true);
    emergency_publisher_ = nh_.advertise<std_msgs::Bool>(sylph_ros::kEmergencyStopTopic, 1, true);
    subscriber_ = nh_.subscribe(sylph_ros::kAdgStateTopic, 100, &CentralNodeTest::onState, this);
    const sylph::Configuration starts = mission().front();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      robots_.push_back(
          std::make_unique<test::MockRobot>(nh_, names_[i], frame_, frame_.toPoint(starts[i])));
    }
    start();
  }
  ~CentralNodeTest() override {
    node_.reset();
    std::filesystem::remove_all(folder_);
  }

  void start() {
    state_ = AdgState();
    node_ = std::make_unique<CentralNode>(nh_, private_nh_);
    const bool is_up = spinUntil([&] {
      return state_.robots.size() == names_.size() && publisher_.getNumSubscribers() == 1 &&
             std::all_of(robots_.begin(), robots_.end(),
                         [](const auto& robot) { return robot->isConnected(); });
    });
    ASSERT_TRUE(is_up);
  }

  /// Handles messages, with the robots taking a step every `pace_s_`, until the condition holds.
  bool spinUntil(const std::function<bool()>& condition, double timeout_s = 10.0) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout_s);
    while (ros::WallTime::now() < deadline) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.005));
      if (ros::WallTime::now() >= next_step_) {
        next_step_ = ros::WallTime::now() + ros::WallDuration(pace_s_);
        for (const auto& robot : robots_) {
          robot->step();
        }
        requireDistinctPlaces();
      }
      if (condition()) {
        return true;
      }
    }
    return condition();
  }

  bool spinUntilPhase(std::uint8_t phase, double timeout_s = 10.0) {
    return spinUntil([&] { return state_.phase == phase; }, timeout_s);
  }

  void send(const sylph_msgs::JointActions& plan) { publisher_.publish(plan); }

  bool call(const std::string& service) {
    std_srvs::Trigger trigger;
    // The node under test lives in this thread, so the call must not block it.
    std::atomic<bool> is_over{false};
    std::thread caller([&] {
      ros::service::call(nh_.resolveName(service), trigger);
      is_over = true;
    });
    spinUntil([&] { return is_over.load(); });
    caller.join();
    return trigger.response.success != 0;
  }

  /// Exit status and output of one of the operator's commands.
  std::pair<int, std::string> command(const std::string& name) {
    const std::string folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    std::pair<int, std::string> ending;
    std::atomic<bool> is_over{false};
    std::thread caller([&] {
      FILE* pipe = popen(("env ROS_NAMESPACE=/ " + folder + "/" + name + " 2>&1").c_str(), "r");
      std::array<char, 512> buffer{};
      while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
        ending.second += buffer.data();
      }
      ending.first = WEXITSTATUS(pclose(pipe));
      is_over = true;
    });
    spinUntil([&] { return is_over.load(); }, 20.0);
    caller.join();
    return ending;
  }

  void onState(const AdgState& state) {
    EXPECT_EQ("map", state.header.frame_id);
    EXPECT_FALSE(state.header.stamp.isZero());
    state_ = state;
    std::set<sylph::Cell> held;
    for (const RobotExecution& robot : state.robots) {
      for (const sylph_msgs::Cell& cell : robot.held_cells) {
        EXPECT_TRUE(held.insert(sylph_ros::fromMessage(cell)).second)
            << "two robots hold " << sylph_ros::fromMessage(cell);
      }
    }
  }

  void requireDistinctPlaces() {
    std::set<std::pair<double, double>> places;
    for (const auto& robot : robots_) {
      EXPECT_TRUE(places.insert({robot->position().x, robot->position().y}).second);
    }
  }

  /// Each task of the mission was carried out once and in order.
  void expectCarriedOutOnce() {
    const std::vector<std::size_t> moves = {4, 4, 3};
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      ASSERT_EQ(moves[i], robots_[i]->carried_out.size()) << names_[i];
      for (std::size_t k = 0; k < moves[i]; ++k) {
        EXPECT_EQ(k, robots_[i]->carried_out[k].sequence);
      }
    }
  }

  YAML::Node result() const { return YAML::LoadFile(folder_ + "/result.yaml"); }
  const RobotExecution& robot(std::size_t i) const { return state_.robots.at(i); }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  sylph::CellFrame frame_;
  std::string folder_;
  std::vector<std::string> names_ = {"robot_0", "robot_1", "robot_2"};
  std::vector<std::unique_ptr<test::MockRobot>> robots_;
  std::unique_ptr<CentralNode> node_;
  ros::Publisher publisher_;
  ros::Publisher emergency_publisher_;
  ros::Subscriber subscriber_;
  AdgState state_;
  double pace_s_ = 0.02;
  ros::WallTime next_step_;
};

}  // namespace sylph_adg_central
