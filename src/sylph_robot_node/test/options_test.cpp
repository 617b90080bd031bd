#include "sylph_robot_node/options.hpp"

#include <gtest/gtest.h>
#include <ros/init.h>

#include <stdexcept>
#include <string>

namespace sylph_robot_node {
namespace {

const std::string kExperiment = SYLPH_TEST_DATA "/small_lab.yaml";

/// Options of /robot_0 with private parameters in a namespace of their own.
class OptionsTest : public testing::Test {
 protected:
  OptionsTest() : private_nh_("~case") { private_nh_.deleteParam(""); }

  Options load() { return loadOptions(ros::NodeHandle("/robot_0"), private_nh_); }

  std::string complaint() {
    try {
      load();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  ros::NodeHandle private_nh_;
};

TEST_F(OptionsTest, TheShippedFileHasTheDefaultsAndEveryNumber) {
  const ros::NodeHandle shipped("~shipped");
  const Options options = loadOptions(ros::NodeHandle("/robot_0"), shipped);
  EXPECT_EQ("robot_0", options.robot);
  EXPECT_DOUBLE_EQ(50.0, options.control_rate_hz);
  EXPECT_DOUBLE_EQ(0.02, options.controller.period_s);
  EXPECT_EQ(15, options.grid.size());
  XmlRpc::XmlRpcValue parameters;
  ASSERT_TRUE(shipped.getParam(shipped.getNamespace(), parameters));
  const sylph::FollowerOptions defaults;
  EXPECT_DOUBLE_EQ(defaults.blend_m, options.controller.follower.blend_m);
  EXPECT_DOUBLE_EQ(defaults.approach_gain, options.controller.follower.approach_gain);
  EXPECT_DOUBLE_EQ(defaults.cross.proportional, options.controller.follower.cross.proportional);
  EXPECT_DOUBLE_EQ(defaults.heading.proportional, options.controller.follower.heading.proportional);
}

TEST_F(OptionsTest, SharedNumbersComeFromTheExperiment) {
  const Options options = load();
  const sylph::ExecutionSpec execution;  // the file keeps the defaults
  EXPECT_DOUBLE_EQ(execution.speed_limit_mps, options.controller.limits.speed_mps);
  EXPECT_DOUBLE_EQ(execution.speed_limit_mps, options.controller.follower.speed_limit_mps);
  EXPECT_DOUBLE_EQ(execution.position_tolerance_m, options.controller.arrival.position_tolerance_m);
  EXPECT_DOUBLE_EQ(execution.pose_timeout_s, options.controller.watch.timeout_s);
  EXPECT_DOUBLE_EQ(0.3, options.cell_size_m);
}

TEST_F(OptionsTest, TheNameMayBeGiven) {
  private_nh_.setParam("robot", "robot_1");
  EXPECT_EQ("robot_1", load().robot);
}

TEST_F(OptionsTest, RefusesARobotThatIsNotInTheExperiment) {
  private_nh_.setParam("robot", "robot_7");
  EXPECT_EQ("robot robot_7: not in " + kExperiment + ", which has robot_0, robot_1", complaint());
}

TEST_F(OptionsTest, RefusesAnUnknownParameter) {
  private_nh_.setParam("cross_gian", 3.0);
  EXPECT_NE(std::string::npos, complaint().find("cross_gian: unknown"));
}

TEST_F(OptionsTest, RefusesAWrongType) {
  private_nh_.setParam("cross_gain", "high");
  EXPECT_NE(std::string::npos, complaint().find("cross_gain = \"high\": must be a number"));
}

TEST_F(OptionsTest, TakesACopyOfTheExperimentOnThisComputer) {
  private_nh_.setParam("experiment", kExperiment);
  ros::NodeHandle("/elsewhere/sylph").setParam("experiment", "/nowhere.yaml");
  EXPECT_EQ("robot_0", loadOptions(ros::NodeHandle("/elsewhere/robot_0"), private_nh_).robot);
}

TEST_F(OptionsTest, RefusesAMissingExperiment) {
  private_nh_.setParam("experiment", "/nowhere.yaml");
  EXPECT_NE(std::string::npos, complaint().find("/nowhere.yaml"));
}

struct OutOfBounds {
  const char* name;
  double value;
};

class BoundsTest : public OptionsTest, public testing::WithParamInterface<OutOfBounds> {};

TEST_P(BoundsTest, RefusesAValueOutOfBounds) {
  private_nh_.setParam(GetParam().name, GetParam().value);
  EXPECT_NE(std::string::npos, complaint().find(std::string(GetParam().name) + " = "))
      << complaint();
}

INSTANTIATE_TEST_SUITE_P(
    EachNumber, BoundsTest,
    testing::Values(OutOfBounds{"heading_rad", 4.0}, OutOfBounds{"base_latency_s", -0.1},
                    OutOfBounds{"base_lag_s", 2.0}, OutOfBounds{"command_acceleration_mps2", 0.0},
                    OutOfBounds{"stop_deceleration_mps2", 0.0}, OutOfBounds{"slip_limit", 0.6},
                    OutOfBounds{"blend_m", 0.2}, OutOfBounds{"braking_share", 1.5},
                    OutOfBounds{"approach_gain", 0.0}, OutOfBounds{"cross_gain", -1.0},
                    OutOfBounds{"cross_integral_gain", -1.0},
                    OutOfBounds{"cross_integral_limit_mps", -1.0},
                    OutOfBounds{"heading_gain", -1.0}, OutOfBounds{"heading_integral_gain", -1.0},
                    OutOfBounds{"heading_integral_limit_radps", 2.0},
                    OutOfBounds{"heading_correction_deg", 0.0},
                    OutOfBounds{"central_timeout_s", 0.0}, OutOfBounds{"pose_jump_m", 0.0},
                    OutOfBounds{"pose_jump_deg", 0.0}, OutOfBounds{"control_rate_hz", 5.0},
                    OutOfBounds{"report_rate_hz", 60.0}, OutOfBounds{"shutdown_s", 6.0}),
    [](const testing::TestParamInfo<OutOfBounds>& each) { return each.param.name; });

class CountsTest : public OptionsTest, public testing::WithParamInterface<const char*> {};

TEST_P(CountsTest, RefusesZero) {
  private_nh_.setParam(GetParam(), 0);
  EXPECT_NE(std::string::npos, complaint().find(std::string(GetParam()) + " = "));
}

INSTANTIATE_TEST_SUITE_P(EachCount, CountsTest,
                         testing::Values("good_poses", "consistent_poses", "arrival_poses"));

}  // namespace
}  // namespace sylph_robot_node

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "options_test");
  ros::start();
  return RUN_ALL_TESTS();
}
