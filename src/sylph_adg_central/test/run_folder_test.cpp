#include <fcntl.h>
#include <sylph_msgs/ExecuteMissionActionResult.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "central_fixture.hpp"

namespace sylph_adg_central {
namespace {

/// From now on writing to a file that this process has open fails as it does on a full disk.
/// @return to how many descriptors that happens
int fillDiskUnder(const std::string& path) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  int filled = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code is_closed;
    if (std::filesystem::read_symlink(entry.path(), is_closed) == path) {
      filled += dup2(full, std::stoi(entry.path().filename())) < 0 ? 0 : 1;
    }
  }
  close(full);
  return filled;
}

/// What a central node keeps in the folder of its run, and what one that starts again makes of it.
class RunFolderTest : public CentralNodeTest {};

TEST_F(RunFolderTest, ARestartDoesNoTaskTwice) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 2; }));
  node_.reset();
  // While nobody listens, robots go on with what they have, and one node starts again.
  const ros::WallTime until = ros::WallTime::now() + ros::WallDuration(0.3);
  spinUntil([&] { return ros::WallTime::now() > until; });
  start();
  EXPECT_EQ(1U, state_.plan_id);
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  expectCarriedOutOnce();
  EXPECT_TRUE(result()["success"].as<bool>());
}

TEST_F(RunFolderTest, ARestartGetsAPendingPlanAgain) {
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

TEST_F(RunFolderTest, RefusesTheFolderOfARunThatIsOver) {
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntilPhase(AdgState::FINISHED));
  node_.reset();
  nh_.setParam("run_folder_taken", "");  // as the next launch does
  try {
    const CentralNode second(nh_, private_nh_);
    FAIL() << "taken";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ("run folder " + folder_ + ": holds a run that is over; name one that does not exist" +
                  " yet, or none",
              std::string(error.what()));
  }
  EXPECT_TRUE(result()["success"].as<bool>()) << "the old result is lost";
}

TEST_F(RunFolderTest, RefusesTheFolderOfAnotherExperimentMapOrSeed) {
  node_.reset();
  for (const auto& [file, difference] : {std::pair("experiment.yaml", "of another experiment"),
                                         {"map.map", "on another map"},
                                         {"seed.txt", "of another seed"}}) {
    nh_.setParam("run_folder_taken", "");
    const std::string path = folder_ + "/" + file;
    const std::string mine = path + ".mine";
    std::filesystem::copy_file(path, mine);
    std::ofstream(path, std::ios::app) << "2\n";
    try {
      const CentralNode second(nh_, private_nh_);
      ADD_FAILURE() << "taken: " << file;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ("run folder " + folder_ + ": holds a run " + difference +
                    "; name one that does not exist yet, or none",
                std::string(error.what()));
    }
    std::filesystem::rename(mine, path);
  }
  start();
}

TEST_F(RunFolderTest, SaysThatItResumesThePlanOfAnEarlierLaunch) {
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

TEST_F(RunFolderTest, WritesWhyAMissionWasRefused) {
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

TEST_F(RunFolderTest, BreaksAMissionOffThatCannotBeWrittenDown) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 1; }));
  std::filesystem::remove_all(folder_);
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ(folder_ + "/events.jsonl: cannot be written: No such file or directory",
            state_.message);
  EXPECT_EQ(1U, state_.plan_id);
  EXPECT_TRUE(call(sylph_ros::kStopService)) << "the operator's stop does not depend on a disk";
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::STOP; }));
  send(jointActions(mission(), names_, 2));
  ASSERT_TRUE(spinUntil([&] { return state_.plan_id == 2; }));
  EXPECT_EQ(AdgState::REFUSED, state_.phase);
}

TEST_F(RunFolderTest, BreaksAMissionOffOnAFullDisk) {
  pace_s_ = 0.1;
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return robots_[1]->done() >= 1; }));
  ASSERT_EQ(1, fillDiskUnder(folder_ + "/events.jsonl"));
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ(folder_ + "/events.jsonl: cannot be written: No space left on device", state_.message);
  EXPECT_TRUE(call(sylph_ros::kStopService));
  ASSERT_TRUE(spinUntil([&] { return state_.mode == AdgState::STOP; }));
}

TEST_F(RunFolderTest, SaysThatTheDiskIsFullForItsResult) {
  send(jointActions(mission(), names_, 1));
  ASSERT_TRUE(spinUntil([&] { return state_.plan_id == 1; }));
  std::filesystem::create_symlink("/dev/full", folder_ + "/result.yaml");
  ASSERT_TRUE(spinUntilPhase(AdgState::REFUSED));
  EXPECT_EQ(folder_ + "/result.yaml: cannot be written: No space left on device", state_.message);
}

}  // namespace
}  // namespace sylph_adg_central
