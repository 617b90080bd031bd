#include "central_fixture.hpp"

namespace sylph_adg_central {
namespace {

using sylph::Cell;
using sylph::Plan;

TEST_F(CentralNodeTest, CarriesAPlanOutAndWritesTheResult) {
  EXPECT_EQ(AdgState::IDLE, state_.phase);
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  expectCarriedOutOnce();
  EXPECT_EQ(5U, state_.steps);
  const sylph_msgs::Task& first = robots_[0]->carried_out.front();
  EXPECT_EQ("robot_0", first.robot_id);
  EXPECT_EQ("map", first.header.frame_id);
  EXPECT_EQ(4U, first.robot_tasks);
  EXPECT_NEAR(0.45, first.end_pos.x, 1e-9);
  EXPECT_NEAR(1.35, first.end_pos.y, 1e-9);
  EXPECT_EQ(sylph_msgs::Task::ENQUEUED, first.status);
  EXPECT_EQ(1U, first.dependencies.size()) << "it follows robot_1";

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
  EXPECT_EQ(0U, robot(1).tasks_done);
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
  EXPECT_EQ(std::make_pair(0, std::string("stop\n")), command("sylph_pause"))
      << "who is stopped does not drive on to finish a task";
  EXPECT_EQ(0, command("sylph_resume").first);
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::RUN; }));
  EXPECT_EQ(std::make_pair(0, std::string("pause\n")), command("sylph_pause"));
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
  EXPECT_EQ(5U, robot(1).held_cells.size()) << "its cell and those of four tasks ahead";

  const Cell cut_2 = sylph_ros::fromMessage(robot(2).cell);
  const Plan rest = {{{0, 0}, cut_2}, {{1, 0}, cut_2}, {{2, 0}, cut_2}};
  send(jointActions(rest, {"robot_0", "robot_2"}, 2, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_EQ(2U, state_.plan_id);
  EXPECT_EQ(2, robot(0).cell.row);
  EXPECT_EQ(5U, robot(1).held_cells.size());
  EXPECT_FALSE(result()["success"].as<bool>());
  EXPECT_EQ(1, result()["replans"].as<int>());
}

TEST_F(CentralNodeTest, ARobotNodeThatStartsAgainDoesNoTaskTwice) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robot(1).tasks_done >= 2; }));
  const std::uint32_t done = robots_[1]->done();
  robots_[1]->restart();
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_GE(robot(1).tasks_done, done);
  EXPECT_LE(robots_[1]->carried_out.size(), 4U + done - 2U) << "what it had told was not repeated";
}

TEST_F(CentralNodeTest, RefusesAPlanThatDoesNotStartWhereRobotsAre) {
  const auto moveTo = [&](const Cell& cell) {
    robots_[2]->setPosition(frame_.toPoint(cell));
    return spinUntil([&] { return sylph_ros::fromMessage(robot(2).cell) == cell; });
  };
  ASSERT_TRUE(moveTo({4, 4}));
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ("plan 1: robot_2 is in (4,4), and not in its start (3,3)", state_.message);
  EXPECT_FALSE(result()["success"].as<bool>());
  ASSERT_TRUE(moveTo({3, 3}));
  send(jointActions(mission(), names_, state_.last_plan_id + 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
}

TEST_F(CentralNodeTest, HasARobotAlignedBeforeThePlanStarts) {
  node_.reset();
  robots_[2]->setPosition(frame_.toPoint({3, 3}) + sylph::Vector2{0.06, 0.0});
  private_nh_.setParam("align", true);
  start();
  private_nh_.deleteParam("align");
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robot(2).aligning != 0; }));
  EXPECT_EQ(AdgState::PENDING, state_.phase);
  EXPECT_EQ(0, robot(0).aligning + robot(1).aligning);
  EXPECT_NE(std::string::npos, state_.message.find("robot_2 is being aligned")) << state_.message;
  robots_[2]->setPosition(frame_.toPoint({3, 3}));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  EXPECT_EQ(0, robot(2).aligning);
  expectCarriedOutOnce();
}

TEST_F(CentralNodeTest, RefusesAMalformedPlan) {
  sylph_msgs::JointActions plan = jointActions(mission(), names_, 1);
  plan.steps[2].actions[0].to.col += 1;
  send(plan);
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ(0U, state_.message.find("plan 1: step 2: action 2 of robot_0 does not lead from"))
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
