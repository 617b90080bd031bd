#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "fake_planner.hpp"
#include "planner_fixture.hpp"
#include "sylph_core/experiment/experiment.hpp"
#include "sylph_planner_node/send_command.hpp"
#include "sylph_ros/missions.hpp"
#include "sylph_ros/topics.hpp"

namespace sylph_planner_node {
namespace {

using sylph_msgs::AdgState;

struct Outcome {
  int status = -1;   ///< exit status
  std::string said;  ///< on both outputs
};

Outcome send(const std::string& arguments) {
  const std::string command = std::string(SYLPH_SEND_EXECUTABLE) + " " + arguments + " 2>&1";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) {
    outcome.said += part.data();
  }
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// The command runs beside the node; central node, robots and motion capture are mocks.
class SendTest : public PlannerFixture {
 protected:
  sylph::Cell cellOf(std::size_t robot) const {
    const sylph_msgs::Cell cell = central_.state().robots.at(robot).cell;
    return {cell.row, cell.col};
  }

  /// What `--plan-only --wait 2` throws if `planner` below /sylph is the action that plans.
  /// @param meanwhile  called while it runs
  static std::string failureOfPlanningWith(
      const std::string& planner, const std::function<void()>& meanwhile = [] {}) {
    SendRequest request;
    request.goals = readGoals({"robot_0:=2,1"}, sylph::smallLab());
    request.plan_only = true;
    request.wait_s = 2.0;
    const ros::NodeHandle nh("/sylph", {{sylph_ros::kPlanMissionAction, planner}});
    SendCommand command(nh, sylph::smallLab(), request);
    return failureOf([&command] { return command.run(); }, meanwhile);
  }
};

TEST_F(SendTest, TakesARobotToItsGoalRoundThoseThatStay) {
  const Outcome outcome = send("robot_0:=2,1");
  EXPECT_EQ(0, outcome.status) << outcome.said;
  EXPECT_EQ(0U, outcome.said.find("robot_0 to (2,1); 2 robots stay\n")) << outcome.said;
  EXPECT_NE(std::string::npos, outcome.said.find("SUCCESS: ")) << outcome.said;
  EXPECT_EQ((sylph::Cell{2, 1}), cellOf(0));
  EXPECT_EQ(sylph::smallStarts()[1], cellOf(1));
}

TEST_F(SendTest, RefusesWhatIsBehindRobotsThatStayUnlessTheyGiveWay) {
  ASSERT_EQ(0, send("robot_1:=2,2 robot_2:=0,2").status);
  const std::size_t sent = central_.received().size();
  const Outcome refused = send("robot_0:=1,4");
  EXPECT_EQ(2, refused.status);
  EXPECT_EQ(
      "sylph_send: goal (1,4) of robot_0 cannot be reached from its cell (0,0) past robots without "
      "part in the mission: robot_1, robot_2\n",
      refused.said);
  EXPECT_EQ(sent, central_.received().size());
  const Outcome outcome = send("--others-give-way robot_0:=1,4");
  EXPECT_EQ(0, outcome.status) << outcome.said;
  EXPECT_EQ((sylph::Cell{1, 4}), cellOf(0));
  EXPECT_EQ((sylph::Cell{0, 2}), cellOf(2));
}

TEST_F(SendTest, SaysInOneLineWhatIsWrongWithAGoal) {
  EXPECT_EQ(2, send("robot_9:=0,1").status);
  EXPECT_EQ("sylph_send: unknown robot 'robot_9'; the nearest names are robot_0, robot_1\n",
            send("robot_9:=0,1").said);
  EXPECT_EQ(
      "sylph_send: goal (0,4) of robot_0 is where robot_2 stands, which has no part in the "
      "mission\n",
      send("robot_0:=0,4").said);
}

TEST_F(SendTest, SaysWhatItWaitsFor) {
  central_.silencePoseOf("robot_1");
  const Outcome outcome = send("--wait 3 robot_1:=2,2");
  EXPECT_EQ(1, outcome.status);
  EXPECT_EQ(
      "waiting: no good pose of robot_1 (none has come)\n"
      "sylph_send: no good pose of robot_1 (none has come)\n",
      outcome.said);
}

TEST_F(SendTest, LeavesItToThePlannerWhetherItGoesOnWithoutARobotThatStays) {
  central_.silencePoseOf("robot_2");
  const Outcome refused = send("--wait 1 robot_0:=2,1");
  EXPECT_EQ(1, refused.status);
  EXPECT_NE(std::string::npos, refused.said.find("NO_POSE: robot_2 has no part in the mission"))
      << refused.said;
  EXPECT_NE(std::string::npos,
            refused.said.find("with ignore_unseen_robots the planner goes on without"));
  ros::NodeHandle planner("/sylph/sylph_planner");
  planner.setParam("ignore_unseen_robots", true);
  ASSERT_TRUE(startPlannerAgain());
  const Outcome outcome = send("--wait 1 robot_0:=2,1");
  planner.setParam("ignore_unseen_robots", false);
  EXPECT_TRUE(startPlannerAgain());
  EXPECT_EQ(0, outcome.status) << outcome.said;
  EXPECT_EQ((sylph::Cell{2, 1}), cellOf(0));
}

TEST_F(SendTest, SavesNoExperimentWithoutARobot) {
  central_.silencePoseOf("robot_2");
  const std::string path = testing::TempDir() + "sylph_send_unseen.yaml";
  const Outcome refused = send("--wait 1 --save " + path + " robot_0:=2,1");
  EXPECT_EQ(1, refused.status);
  EXPECT_EQ("sylph_send: no good pose of robot_2 (none has come)\n", refused.said);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(SendTest, EndsAsItsMissionDoes) {
  central_.refusePlans("no safety margin");
  const Outcome outcome = send("robot_0:=2,1");
  EXPECT_EQ(1, outcome.status);
  EXPECT_NE(std::string::npos, outcome.said.find("PLAN_REFUSED: ")) << outcome.said;
}

TEST_F(SendTest, ReplacesAMissionOnlyIfToldTo) {
  central_.haltAfter(1);
  client_.sendGoal(sylph_ros::toGoal(sylph::smallLab()));
  ASSERT_TRUE(waitForPhase(AdgState::EXECUTING));
  const Outcome refused = send("robot_0:=2,1");
  EXPECT_EQ(1, refused.status);
  EXPECT_EQ("sylph_send: a mission is under way: wait for its end, or --replace it\n",
            refused.said);
  EXPECT_EQ(AdgState::RUN, central_.state().mode);
  central_.haltAfter(1000);
  const Outcome outcome = send("--replace robot_0:=0,2 robot_1:=2,2 robot_2:=0,3");
  EXPECT_EQ(0, outcome.status) << outcome.said;
  EXPECT_EQ((sylph::Cell{0, 2}), cellOf(0));
}

TEST_F(SendTest, ShowsAPlanAndMovesNothing) {
  const Outcome outcome = send("--plan-only robot_0:=2,1");
  EXPECT_EQ(0, outcome.status) << outcome.said;
  EXPECT_NE(std::string::npos,
            outcome.said.find("3 steps, sum of costs 3, the least there is; checked"))
      << outcome.said;
  EXPECT_NE(std::string::npos,
            outcome.said.find("  robot_0 (0,0) to (2,1): 3 moves, arrives at step 3\n"))
      << outcome.said;
  EXPECT_TRUE(central_.received().empty());
}

TEST_F(SendTest, EndsWithoutAPlanner) {
  const std::string nobody = "no planner: nobody serves the action /nobody/sylph/execute_mission\n";
  const ros::NodeHandle suite("/nobody/sylph");
  suite.setParam("experiment", sylph::smallLab().path);
  const Outcome outcome = send("--wait 1 robot_0:=2,1 __ns:=/nobody");
  suite.deleteParam("experiment");
  EXPECT_EQ(std::make_pair(1, "sylph_send: " + nobody),
            std::make_pair(outcome.status, outcome.said));
  EXPECT_EQ("no planner: nobody serves the action /sylph/nobody/plans",
            failureOfPlanningWith("nobody/plans"));
}

TEST_F(SendTest, EndsWhenThePlannerIsGoneOrHangs) {
  auto planner = std::make_unique<FakePlanner>("/sylph/fake/plan_mission");
  EXPECT_EQ(
      "the planner hangs: no status of the action /sylph/fake/plan_mission for 2 s, or the lab's "
      "time stands still",
      failureOfPlanningWith("fake/plan_mission"));
  planner = std::make_unique<FakePlanner>("/sylph/fake/plan_mission");
  const std::string failure = failureOfPlanningWith("fake/plan_mission", [&planner] {
    EXPECT_TRUE(waitUntil([&planner] { return planner->hasGoal(); }));
    planner.reset();
  });
  EXPECT_EQ("the planner is gone: nobody serves the action /sylph/fake/plan_mission any more",
            failure);
}

TEST_F(SendTest, SavesTheMissionAsAnExperiment) {
  const std::string path = testing::TempDir() + "sylph_send_test.yaml";
  std::filesystem::remove(path);
  const Outcome outcome = send("--save " + path + " robot_0:=2,1");
  EXPECT_EQ(0, outcome.status) << outcome.said;
  const sylph::Experiment saved = sylph::loadExperiment(path);
  EXPECT_EQ((sylph::Cell{0, 0}), saved.robots[0].start);
  EXPECT_EQ((sylph::Cell{2, 1}), saved.robots[0].goal);
  EXPECT_EQ(saved.robots[1].start, saved.robots[1].goal);
  EXPECT_EQ(1, send("--save " + path + " robot_0:=2,1").status) << "a file was overwritten";
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace sylph_planner_node
