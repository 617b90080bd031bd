#include "sylph_planner_node/mission_client.hpp"

#include <gtest/gtest.h>
#include <ros/master.h>
#include <sylph_msgs/TaskReport.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include "fake_planner.hpp"
#include "planner_fixture.hpp"
#include "sylph_core/files/scratch_folder.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;

class MissionClientTest : public PlannerFixture {
 protected:
  void SetUp() override {
    PlannerFixture::SetUp();
    const std::filesystem::path result = writeResult();
    ros::NodeHandle("/sylph").setParam(sylph_ros::kRunFolderParameter,
                                       result.parent_path().string());
  }

  std::string writeResult() const { return folder_.write("result.yaml", "arrived: 3\n"); }

  /// @param mission  fails
  static std::string saidBy(MissionClient& mission) {
    testing::internal::CaptureStdout();
    EXPECT_FALSE(mission.run());
    return testing::internal::GetCapturedStdout();
  }

  /// What a mission throws whose planner serves the action `planner` below /sylph.
  /// @param meanwhile  called while it runs
  static std::string failureWith(
      const std::string& planner, const std::function<void()>& meanwhile = [] {}) {
    ClientOptions options;
    options.start_timeout_s = 2.0;
    const ros::NodeHandle nh("/sylph", {{sylph_ros::kExecuteMissionAction, planner}});
    MissionClient mission(nh, options, sylph::smallLab(), sylph_ros::toGoal(sylph::smallLab()), "");
    return failureOf([&mission] { return mission.run(); }, meanwhile);
  }

  sylph::ScratchFolder folder_{"sylph_mission"};
  MissionClient mission_{ros::NodeHandle("/sylph"), ros::NodeHandle("~client")};
};

TEST_F(MissionClientTest, RunsTheExperimentAndSaysHowItEnded) {
  testing::internal::CaptureStdout();
  std::filesystem::remove(folder_.path("result.yaml"));
  auto has_succeeded = std::async(std::launch::async, [this] { return mission_.run(); });
  EXPECT_TRUE(waitForPhase(AdgState::FINISHED));
  writeResult();
  EXPECT_TRUE(has_succeeded.get());
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(0U, said.find("experiment small_lab: 3 robots, seed 0, planner lacam\n")) << said;
  EXPECT_NE(std::string::npos, said.find("SUCCESS: all 3 robots have arrived\n")) << said;
  EXPECT_NE(std::string::npos, said.find("/result.yaml:\n  arrived: 3\n")) << said;
}

TEST_F(MissionClientTest, FailsWhenTheMissionDoes) {
  central_.refusePlans("no safety margin");
  testing::internal::CaptureStdout();
  const bool has_succeeded = mission_.run();
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_FALSE(has_succeeded);
  EXPECT_NE(std::string::npos, said.find("PLAN_REFUSED")) << said;
  EXPECT_NE(std::string::npos, said.find("result.yaml has not been written\n"))
      << "the result of another mission was taken for that of this one: " << said;
}

TEST_F(MissionClientTest, SaysWhatTheMotionCaptureLacks) {
  central_.silencePoseOf("robot_1");
  ros::NodeHandle("~hasty").setParam("start_timeout_s", 1.0);
  MissionClient hasty(ros::NodeHandle("/sylph"), ros::NodeHandle("~hasty"));
  ros::Publisher publisher =
      ros::NodeHandle().advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1, true);
  diagnostic_msgs::DiagnosticArray diagnostics;
  diagnostics.status.resize(2);
  diagnostics.status[0].name = "sylph/mocap_bridge: link";
  diagnostics.status[0].level = diagnostic_msgs::DiagnosticStatus::ERROR;
  diagnostics.status[0].message = "no frame from 192.168.1.2";
  diagnostics.status[1].name = "sylph/mocap_bridge: bodies";
  diagnostics.status[1].message = "all bodies are seen";
  publisher.publish(diagnostics);
  const std::string said = saidBy(hasty);
  EXPECT_NE(std::string::npos,
            said.find("no pose on /robot_1/pose: is robot_1 seen by the motion capture?\n"
                      "    sylph/mocap_bridge: link: no frame from 192.168.1.2\n"))
      << said;
}

TEST_F(MissionClientTest, NamesAllRobotsWithoutAPose) {
  central_.silencePoseOf("robot_0");
  central_.silencePoseOf("robot_1");
  ros::NodeHandle("~hasty").setParam("start_timeout_s", 1.0);
  MissionClient hasty(ros::NodeHandle("/sylph"), ros::NodeHandle("~hasty"));
  const std::string said = saidBy(hasty);
  EXPECT_NE(std::string::npos,
            said.find("no pose on /robot_0/pose, /robot_1/pose: are robot_0, robot_1 seen"))
      << said;
  EXPECT_NE(std::string::npos,
            said.find("NO_POSE: no pose of robot_0 has come\nno pose of robot_1 has come"))
      << "no answer of the planner, so no result in the run folder: " << said;
}

TEST_F(MissionClientTest, NamesANodeThatIsRegisteredByANameWhichThisComputerDoesNotKnow) {
  central_.silencePoseOf("robot_1");
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue payload;
  request[0] = "/robot_1/robot";
  request[1] = "/robot_1/task_report";
  request[2] = "sylph_msgs/TaskReport";
  request[3] = "http://cf1.invalid:4211/";
  ASSERT_TRUE(ros::master::execute("registerPublisher", request, response, payload, false));
  const ros::NodeHandle options("~patient");
  options.setParam("start_timeout_s", 4.0);
  options.setParam("progress_period_s", 0.2);
  MissionClient patient(ros::NodeHandle("/sylph"), options);
  const std::string said = saidBy(patient);
  EXPECT_NE(std::string::npos, said.find("/robot_1/robot is registered at ")) << said;
  EXPECT_NE(std::string::npos, said.find("no address of 'cf1.invalid': set ROS_IP")) << said;
  XmlRpc::XmlRpcValue again;
  again[0] = request[0];
  again[1] = request[1];
  again[2] = request[3];
  EXPECT_TRUE(ros::master::execute("unregisterPublisher", again, response, payload, false));
}

TEST_F(MissionClientTest, NamesANamespaceInWhichARobotReportsInstead) {
  central_.silencePoseOf("robot_1");
  ros::Publisher elsewhere =
      ros::NodeHandle().advertise<sylph_msgs::TaskReport>("/other_lab/robot_1/task_report", 1);
  const ros::NodeHandle options("~patient");
  options.setParam("start_timeout_s", 2.0);
  options.setParam("progress_period_s", 0.2);
  MissionClient patient(ros::NodeHandle("/sylph"), options);
  const std::string said = saidBy(patient);
  EXPECT_NE(std::string::npos,
            said.find("    robot_1 reports on /other_lab/robot_1/task_report, and is waited for on "
                      "/robot_1/task_report: is ROS_NAMESPACE set on one side only?\n"))
      << said;
}

TEST_F(MissionClientTest, EndsWithoutAPlanner) {
  EXPECT_EQ("no planner: nobody serves the action /sylph/nobody/serves_this",
            failureWith("nobody/serves_this"));
}

TEST_F(MissionClientTest, EndsWhenThePlannerIsGone) {
  auto planner = std::make_unique<FakePlanner>("/sylph/fake/execute_mission");
  const std::string failure = failureWith("fake/execute_mission", [&planner] {
    EXPECT_TRUE(waitUntil([&planner] { return planner->hasGoal(); }));
    planner.reset();
  });
  EXPECT_EQ(
      "the planner is gone: nobody serves the action /sylph/fake/execute_mission any more; the "
      "robots finish the plan that they have",
      failure);
}

TEST_F(MissionClientTest, EndsWhenThePlannerHangs) {
  const FakePlanner planner("/sylph/fake/execute_mission");
  EXPECT_EQ(
      "the planner hangs: no status of the action /sylph/fake/execute_mission for 2 s, or the "
      "lab's time stands still; the robots finish the plan that they have",
      failureWith("fake/execute_mission"));
  EXPECT_TRUE(planner.hasGoal());
}

TEST_F(MissionClientTest, GivesAPlannerThatWasStartedAgainTheMissionAnew) {
  std::atomic<bool> follows{false};
  const boost::function<void(const sylph_msgs::ExecuteMissionActionFeedback&)> note =
      [&follows](const sylph_msgs::ExecuteMissionActionFeedback& message) {
        follows = message.feedback.phase == "executing";
      };
  ros::Subscriber feedback = ros::NodeHandle().subscribe<sylph_msgs::ExecuteMissionActionFeedback>(
      "/sylph/execute_mission/feedback", 1, note);
  central_.haltAfter(1);
  auto has_succeeded = std::async(std::launch::async, [this] { return mission_.run(); });
  ASSERT_TRUE(waitForPhase(AdgState::EXECUTING));
  const std::uint32_t plan_id = central_.state().plan_id;
  ASSERT_TRUE(shutDown("/sylph/sylph_planner"));
  ASSERT_TRUE(waitUntil([&feedback] { return feedback.getNumPublishers() == 0; }));
  follows = false;
  ASSERT_TRUE(waitUntil([&follows] { return follows.load(); }));
  central_.haltAfter(1000);
  EXPECT_TRUE(has_succeeded.get());
  EXPECT_EQ(plan_id, central_.state().plan_id) << "the plan under way was not followed";
  feedback.shutdown();
}

}  // namespace
}  // namespace sylph_planner_node
