#include "sylph_planner_node/options.hpp"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "sylph_planner_node/mission_client.hpp"

namespace sylph_planner_node {
namespace {

std::string errorOf(const ros::NodeHandle& nh) {
  try {
    sylph_ros::readStrictly(nh, readOptions);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(OptionsTest, TheShippedFilesHoldTheDefaults) {
  const Options options = sylph_ros::readStrictly(ros::NodeHandle("~planner"), readOptions);
  EXPECT_DOUBLE_EQ(Options().pose_timeout_s, options.pose_timeout_s);
  EXPECT_DOUBLE_EQ(Options().limits.central_wait_s, options.limits.central_wait_s);
  EXPECT_DOUBLE_EQ(Options().limits.replanning_time_limit_s,
                   options.limits.replanning_time_limit_s);
  const ClientOptions client =
      sylph_ros::readStrictly(ros::NodeHandle("~mission"), readClientOptions);
  EXPECT_EQ(ClientOptions().exit_when_done, client.exit_when_done);
  EXPECT_DOUBLE_EQ(ClientOptions().start_timeout_s, client.start_timeout_s);
}

TEST(OptionsTest, RefuseWhatIsForbiddenMistypedOrUnknown) {
  const ros::NodeHandle forbidden("~forbidden");
  forbidden.setParam("tick_period_s", -0.1);
  EXPECT_EQ("parameter /planner_node/forbidden/tick_period_s = -0.1: must be > 0",
            errorOf(forbidden));
  const ros::NodeHandle mistyped("~mistyped");
  mistyped.setParam("resend_period_s", "soon");
  EXPECT_EQ("parameter /planner_node/mistyped/resend_period_s = \"soon\": must be a number",
            errorOf(mistyped));
  const ros::NodeHandle unknown("~unknown");
  unknown.setParam("tick_perriod_s", 0.1);
  EXPECT_EQ(0U, errorOf(unknown).find("parameter /planner_node/unknown/tick_perriod_s: unknown"));
}

TEST(OptionsTest, ANodeWithoutExperimentExitsWithFailure) {
  for (const std::string executable : {SYLPH_PLANNER_EXECUTABLE, SYLPH_MISSION_EXECUTABLE}) {
    const std::string command = executable + " __ns:=/without/experiment";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status)) << command;
    EXPECT_EQ(EXIT_FAILURE, WEXITSTATUS(status)) << command;
  }
}

TEST(OptionsTest, ANodeWhoseWeightsCannotBeReadExitsWithFailure) {
  const ros::NodeHandle suite("/with/bad_weights");
  suite.setParam("experiment", SYLPH_TEST_DATA "/small_lab.yaml");
  suite.setParam("planner", "sylph_lacam");
  suite.setParam("weights", SYLPH_TEST_DATA "/small.map");
  for (const std::string executable : {SYLPH_PLANNER_EXECUTABLE, SYLPH_MISSION_EXECUTABLE}) {
    const std::string command = executable + " __ns:=/with/bad_weights";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status)) << command;
    EXPECT_EQ(EXIT_FAILURE, WEXITSTATUS(status)) << command;
  }
}

}  // namespace
}  // namespace sylph_planner_node
