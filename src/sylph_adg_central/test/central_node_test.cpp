#include "sylph_adg_central/central_node.hpp"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <sylph_msgs/AdgState.h>
#include <sylph_msgs/ExecuteMissionActionResult.h>
#include <sylph_msgs/RobotExecution.h>
#include <sys/wait.h>
#include <yaml-cpp/yaml.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <thread>

#include "mock_robot.hpp"
#include "sylph_core/execution/mission_plan.hpp"
#include "sylph_ros/conversions.hpp"
#include "sylph_ros/plan_messages.hpp"

namespace sylph_adg_central {
namespace {

using sylph::Cell;
using sylph::Plan;
using sylph_msgs::AdgState;
using sylph_msgs::RobotExecution;

/// A plan as its planner sends it; every robot's partner is the first one.
sylph_msgs::JointActions jointActions(const Plan& plan, const std::vector<std::string>& robots,
                                      std::uint32_t plan_id, std::uint32_t replaces_plan_id = 0) {
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
Plan mission() {
  return {{{0, 0}, {0, 1}, {3, 3}}, {{0, 1}, {0, 2}, {3, 3}}, {{0, 2}, {0, 3}, {3, 3}},
          {{0, 3}, {0, 4}, {2, 3}}, {{0, 4}, {0, 5}, {1, 3}}, {{0, 4}, {0, 5}, {0, 3}}};
}

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
    std::set<Cell> held;
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

TEST_F(CentralNodeTest, CarriesAPlanOutAndWritesTheResult) {
  EXPECT_EQ(AdgState::IDLE, state_.phase);
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  expectCarriedOutOnce();
  EXPECT_EQ(5u, state_.steps);
  const sylph_msgs::Task& first = robots_[0]->carried_out.front();
  EXPECT_EQ("robot_0", first.robot_id);
  EXPECT_EQ("map", first.header.frame_id);
  EXPECT_EQ(4u, first.robot_tasks);
  EXPECT_NEAR(0.45, first.end_pos.x, 1e-9);
  EXPECT_NEAR(1.35, first.end_pos.y, 1e-9);
  EXPECT_EQ(sylph_msgs::Task::ENQUEUED, first.status);
  EXPECT_EQ(1u, first.dependencies.size()) << "it follows robot_1";

  const YAML::Node yaml = result();
  EXPECT_TRUE(yaml["success"].as<bool>());
  EXPECT_EQ(3, yaml["robots"].as<int>());
  EXPECT_EQ(3, yaml["arrived"].as<int>());
  EXPECT_EQ(5, yaml["plan_steps"].as<int>());
  EXPECT_EQ(4 + 4 + 5, yaml["sum_of_costs"].as<int>());
  EXPECT_NEAR(0.5, yaml["planning_s"].as<double>(), 1e-9);
  EXPECT_GT(yaml["execution_s"].as<double>(), 0.0);
  EXPECT_GE(yaml["critical_path_cells"].as<int>(), 5);
  EXPECT_NEAR(yaml["critical_path_cells"].as<int>() * 1.2, yaml["ideal_execution_s"].as<double>(),
              1e-9);
  EXPECT_NEAR(0.004, yaml["max_tracking_error_m"].as<double>(), 1e-9);
  EXPECT_EQ(0, yaml["replans"].as<int>());
  EXPECT_EQ(0, yaml["stops"].as<int>());
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/experiment.yaml"));
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/plan.txt"));
}

TEST_F(CentralNodeTest, ArrivesOverABadLine) {
  robots_[0]->faults.drop_task_every = 2;
  robots_[1]->faults.drop_report_every = 3;
  robots_[1]->faults.doubles_reports = true;
  robots_[2]->faults.repeats_old_reports = true;
  send(jointActions(mission(), names_, 2));
  ASSERT_TRUE(spinUntilPhase(AdgState::EXECUTING));
  send(jointActions(mission(), names_, 2));  // again,
  send(jointActions(mission(), names_, 1));  // an old one,
  send(sylph_msgs::JointActions());          // and none
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED, 20.0));
  expectCarriedOutOnce();
}

TEST_F(CentralNodeTest, DropsReportsOfAnotherPlan) {
  robots_[1]->is_silent = true;  // it leads; the test speaks for it
  ros::Publisher impostor = nh_.advertise<sylph_msgs::TaskReport>(
      sylph_ros::robotTopic(nh_, "robot_1", sylph_ros::kTaskReportTopic), 10);
  ASSERT_TRUE(spinUntil([&] { return impostor.getNumSubscribers() > 0; }));
  sylph_msgs::TaskReport report;
  const auto tell = [&](std::uint32_t plan_id, std::uint32_t done) {
    report.header.stamp = ros::Time::now();
    report.report_id += 1000;
    report.plan_id = plan_id;
    report.accepted = done;
    report.done = done;
    const sylph::Point start = frame_.toPoint({0, 1});
    report.x = start.x;
    report.y = start.y;
    impostor.publish(report);
  };
  send(jointActions(mission(), names_, 5));
  ASSERT_TRUE(spinUntil([&] {
    tell(0, 0);
    return state_.phase == AdgState::EXECUTING;
  }));
  tell(4, 2);
  tell(6, 2);
  const std::uint32_t waits_at = robots_[0]->done();
  ASSERT_TRUE(spinUntil([&] { return robot(0).waiting && robot(0).waited_s > 0.3; }));
  EXPECT_EQ("robot_1", robot(0).waits_for_robot);
  EXPECT_EQ(waits_at, robots_[0]->done());
  EXPECT_EQ(0u, robot(1).tasks_done);
}

TEST_F(CentralNodeTest, PausesStopsAndResumes) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 1; }));
  ASSERT_TRUE(call(sylph_ros::kPauseService));
  ASSERT_TRUE(spinUntil([&] {
    return state_.mode == AdgState::PAUSE &&
           std::none_of(robots_.begin(), robots_.end(),
                        [](const auto& robot) { return robot->hasTask(); });
  }));
  EXPECT_EQ("by the operator", state_.message);
  EXPECT_EQ(AdgState::EXECUTING, state_.phase);
  ASSERT_TRUE(call(sylph_ros::kStopService));
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::STOP; }));
  ASSERT_TRUE(call(sylph_ros::kResumeService));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  expectCarriedOutOnce();
  EXPECT_EQ(1, result()["stops"].as<int>());
}

TEST_F(CentralNodeTest, ObeysTheOperatorsCommands) {
  EXPECT_EQ(std::make_pair(0, std::string("stop\n")), command("sylph_stop"));
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::STOP; }));
  EXPECT_EQ(0, command("sylph_pause").first);
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::PAUSE; }));
  EXPECT_EQ(0, command("sylph_resume").first);
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::RUN; }));
  EXPECT_EQ(1, command("sylph_stop now").first);
  node_.reset();
  const auto [status, output] = command("sylph_stop");
  EXPECT_EQ(1, status);
  EXPECT_EQ("sylph_stop: nobody serves /sylph/stop: no central node in this namespace\n", output);
  start();
}

TEST_F(CentralNodeTest, AnEmergencyStopHoldsUntilItIsReset) {
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::EXECUTING));
  std_msgs::Bool emergency;
  emergency.data = 1;
  emergency_publisher_.publish(emergency);
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::STOP; }));
  EXPECT_FALSE(call(sylph_ros::kResumeService)) << "the separation monitor has to be reset first";
  EXPECT_EQ(AdgState::STOP, state_.mode);
  emergency.data = 0;
  emergency_publisher_.publish(emergency);
  ASSERT_TRUE(spinUntil([&] { return call(sylph_ros::kResumeService); }));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_EQ(1, result()["stops"].as<int>());
}

TEST_F(CentralNodeTest, PlansGoOnAroundALostRobot) {
  robots_[1]->is_halted = true;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robot(0).waiting; }));
  EXPECT_EQ("robot_1", robot(0).root_cause_robot);
  sylph_msgs::DeclareLost lost;
  lost.request.robot_id = "robot_1";
  std::atomic<bool> is_over{false};
  std::thread caller([&] {
    ros::service::call(nh_.resolveName(sylph_ros::kDeclareLostService), lost);
    is_over = true;
  });
  spinUntil([&] { return is_over.load(); });
  caller.join();
  EXPECT_TRUE(lost.response.success) << lost.response.message;
  ASSERT_TRUE(spinUntilPhase(AdgState::AT_CUT));
  EXPECT_EQ(RobotExecution::LOST, robot(1).condition);
  EXPECT_EQ(0, robot(0).cell.col);
  EXPECT_EQ(5u, robot(1).held_cells.size()) << "its cell and those of four tasks ahead";

  const Cell cut_2 = sylph_ros::fromMessage(robot(2).cell);
  const Plan rest = {{{0, 0}, cut_2}, {{1, 0}, cut_2}, {{2, 0}, cut_2}};
  send(jointActions(rest, {"robot_0", "robot_2"}, 2, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_EQ(2u, state_.plan_id);
  EXPECT_EQ(2, robot(0).cell.row);
  EXPECT_EQ(5u, robot(1).held_cells.size());
  EXPECT_FALSE(result()["success"].as<bool>());
  EXPECT_EQ(1, result()["replans"].as<int>());
}

TEST_F(CentralNodeTest, ARestartDoesNoTaskTwice) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 2; }));
  node_.reset();
  // While nobody listens, robots go on with what they have, and one node starts again.
  const ros::WallTime until = ros::WallTime::now() + ros::WallDuration(0.3);
  spinUntil([&] { return ros::WallTime::now() > until; });
  start();
  EXPECT_EQ(1u, state_.plan_id);
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  expectCarriedOutOnce();
  EXPECT_TRUE(result()["success"].as<bool>());
}

TEST_F(CentralNodeTest, ARestartGetsAPendingPlanAgain) {
  robots_[2]->setPosition(frame_.toPoint({3, 3}));
  robots_[2]->is_silent = true;
  ASSERT_TRUE(spinUntil([&] { return robot(2).condition == RobotExecution::SILENT; }));
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::PENDING));
  node_.reset();
  start();
  ASSERT_TRUE(spinUntilPhase(AdgState::PENDING));
  robots_[2]->is_silent = false;
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  expectCarriedOutOnce();
}

TEST_F(CentralNodeTest, RefusesTheFolderOfARunThatIsOver) {
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  node_.reset();
  nh_.setParam("run_folder_taken", "");  // as the next launch does
  try {
    CentralNode(nh_, private_nh_);
    FAIL() << "taken";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ("run folder " + folder_ + ": holds a run that is over; name one that does not exist" +
                  " yet, or none",
              std::string(error.what()));
  }
  EXPECT_TRUE(result()["success"].as<bool>()) << "the old result is lost";
}

TEST_F(CentralNodeTest, RefusesTheFolderOfAnotherExperiment) {
  node_.reset();
  nh_.setParam("run_folder_taken", "");
  std::ofstream(folder_ + "/experiment.yaml", std::ios::app) << "# another one\n";
  EXPECT_THROW(CentralNode(nh_, private_nh_), std::runtime_error);
}

TEST_F(CentralNodeTest, SaysThatItResumesThePlanOfAnEarlierLaunch) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 1; }));
  node_.reset();
  ASSERT_TRUE(std::filesystem::exists(folder_ + "/result.yaml"));
  nh_.setParam("run_folder_taken", "");
  start();
  EXPECT_EQ("plan 1 of an earlier launch is resumed; to drop it, start with another run folder" +
                std::string(" than ") + folder_,
            state_.message);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/result.yaml")) << "to be taken for the new one";
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_TRUE(result()["success"].as<bool>());
}

TEST_F(CentralNodeTest, WritesWhyAMissionWasRefused) {
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  ASSERT_TRUE(result()["success"].as<bool>());
  ros::Publisher planner =
      nh_.advertise<sylph_msgs::ExecuteMissionActionResult>("execute_mission/result", 1);
  ASSERT_TRUE(spinUntil([&] { return planner.getNumSubscribers() > 0; }));
  sylph_msgs::ExecuteMissionActionResult refused;
  refused.result.outcome = sylph_msgs::ExecuteMissionResult::NO_PLAN;
  refused.result.message = "planner lacam found no plan";
  refused.result.robots = 2;
  planner.publish(refused);
  ASSERT_TRUE(spinUntil([&] { return !result()["success"].as<bool>(); }));
  EXPECT_EQ("planner lacam found no plan", result()["message"].as<std::string>());
  EXPECT_EQ(2, result()["robots"].as<int>());
}

TEST_F(CentralNodeTest, BreaksAMissionOffThatCannotBeWrittenDown) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 1; }));
  std::filesystem::remove_all(folder_);
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ(folder_ + "/events.jsonl: cannot be written: No such file or directory",
            state_.message);
  EXPECT_EQ(1u, state_.plan_id);
  EXPECT_TRUE(call(sylph_ros::kStopService)) << "the operator's stop does not depend on a disk";
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::STOP; }));
  send(jointActions(mission(), names_, 2));
  ASSERT_TRUE(spinUntil([&] { return state_.plan_id == 2; }));
  EXPECT_EQ(AdgState::REFUSED, state_.phase);
}

TEST_F(CentralNodeTest, ARobotNodeThatStartsAgainDoesNoTaskTwice) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robot(1).tasks_done >= 2; }));
  const std::uint32_t done = robots_[1]->done();
  robots_[1]->restart();
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_GE(robot(1).tasks_done, done);
  EXPECT_LE(robots_[1]->carried_out.size(), 4u + done - 2u) << "what it had told was not repeated";
}

TEST_F(CentralNodeTest, RefusesAPlanThatDoesNotStartWhereRobotsAre) {
  const auto moveTo = [&](const Cell& cell) {
    robots_[2]->setPosition(frame_.toPoint(cell));
    return spinUntil([&] { return sylph_ros::fromMessage(robot(2).cell) == cell; });
  };
  ASSERT_TRUE(moveTo({4, 4}));
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ("plan 1: it starts robot_2 in (3,3), but the robot is in (4,4)", state_.message);
  EXPECT_FALSE(result()["success"].as<bool>());
  ASSERT_TRUE(moveTo({3, 3}));
  send(jointActions(mission(), names_, state_.last_plan_id + 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
}

TEST_F(CentralNodeTest, RefusesAMalformedPlan) {
  sylph_msgs::JointActions plan = jointActions(mission(), names_, 1);
  plan.steps[2].actions[0].to.col += 1;
  send(plan);
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ(0u, state_.message.find("plan 1: step 2: action 2 of robot_0 does not lead from"))
      << state_.message;
}

TEST_F(CentralNodeTest, NoticesASilentRobot) {
  robots_[1]->is_silent = true;
  ASSERT_TRUE(spinUntil([&] { return robot(1).condition == RobotExecution::SILENT; }));
  EXPECT_EQ(RobotExecution::OK, robot(0).condition);
  robots_[1]->is_silent = false;
  ASSERT_TRUE(spinUntil([&] { return robot(1).condition == RobotExecution::OK; }));
}

}  // namespace
}  // namespace sylph_adg_central

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "central_node_test");
  const ros::NodeHandle keep_ros_running;
  return RUN_ALL_TESTS();
}
