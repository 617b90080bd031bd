#include "sylph_sim/options.hpp"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <string>

namespace sylph_sim {
namespace {

sylph::Experiment twoRobots() {
  sylph::Experiment experiment;
  experiment.robots.resize(2);
  experiment.robots[0].name = "robot_0";
  experiment.robots[1].name = "robot_1";
  return experiment;
}

/// The parameters below this name are one test's own.
ros::NodeHandle own(const std::string& name) {
  return {"~/" + name};
}

/// What is said when the options are loaded; empty if nothing is wrong.
std::string complaint(const ros::NodeHandle& nh) {
  try {
    sylph_ros::readStrictly(nh, readOptions);
    loadFaults(nh, twoRobots());
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

void expectComplaint(const std::string& parameter, const XmlRpc::XmlRpcValue& value,
                     const std::string& expected) {
  static int tests = 0;
  const ros::NodeHandle nh = own("bad_" + std::to_string(++tests));
  nh.setParam(parameter, value);
  EXPECT_NE(std::string::npos, complaint(nh).find(expected))
      << parameter << ": '" << complaint(nh) << "' lacks '" << expected << "'";
}

XmlRpc::XmlRpcValue faultList(const std::string& field, const XmlRpc::XmlRpcValue& value) {
  XmlRpc::XmlRpcValue list;
  list[0]["kind"] = "lost";
  list[0][field] = value;
  return list;
}

TEST(OptionsTest, TheShippedFileHasTheDefaults) {
  const Options shipped = sylph_ros::readStrictly(own("shipped"), readOptions);
  const Options defaults;
  EXPECT_EQ(defaults.simulation.step_rate_hz, shipped.simulation.step_rate_hz);
  EXPECT_EQ(defaults.simulation.start_offset_m, shipped.simulation.start_offset_m);
  EXPECT_EQ(defaults.simulation.base.wheel_lag_s, shipped.simulation.base.wheel_lag_s);
  EXPECT_EQ(defaults.simulation.base.lateral_slip, shipped.simulation.base.lateral_slip);
  EXPECT_EQ(defaults.simulation.base.geometry.half_track_m,
            shipped.simulation.base.geometry.half_track_m);
  EXPECT_EQ(defaults.simulation.cameras.rate_hz, shipped.simulation.cameras.rate_hz);
  EXPECT_EQ(defaults.simulation.cameras.latency_s, shipped.simulation.cameras.latency_s);
  EXPECT_EQ(defaults.natnet.version, shipped.natnet.version);
  EXPECT_EQ(defaults.natnet.command_port, shipped.natnet.command_port);
  EXPECT_EQ(defaults.natnet.up_axis, shipped.natnet.up_axis);
  EXPECT_EQ(defaults.natnet.multicast_group, shipped.natnet.multicast_group);
  EXPECT_EQ(defaults.clock_period_s, shipped.clock_period_s);
  EXPECT_EQ(defaults.truth_rate_hz, shipped.truth_rate_hz);
  EXPECT_TRUE(loadFaults(own("shipped"), twoRobots()).empty());
}

TEST(OptionsTest, ReadsAFaultScript) {
  const ros::NodeHandle nh = own("script");
  XmlRpc::XmlRpcValue list;
  list[0]["kind"] = "jump";
  list[0]["robots"][0] = "robot_1";
  list[0]["at_s"] = 2;
  list[0]["duration_s"] = 0.5;
  list[0]["value"] = -0.2;
  list[1]["kind"] = "silent";
  nh.setParam("faults", list);
  const std::vector<Fault> faults = loadFaults(nh, twoRobots());
  ASSERT_EQ(2U, faults.size());
  EXPECT_EQ(FaultKind::Jump, faults[0].kind);
  EXPECT_EQ(std::vector<std::size_t>{1}, faults[0].robots);
  EXPECT_EQ(2.0, faults[0].at_s);
  EXPECT_EQ(0.5, faults[0].duration_s);
  EXPECT_EQ(-0.2, faults[0].value);
  EXPECT_EQ(FaultKind::Silent, faults[1].kind);
  EXPECT_TRUE(std::isinf(faults[1].duration_s));
}

TEST(OptionsTest, BadParametersAreNamed) {
  expectComplaint("step_rate_hz", 0.0, "step_rate_hz");
  expectComplaint("step_rat_hz", 200.0, "step_rat_hz: unknown");
  expectComplaint("base/wheel_lag_s", -1.0, "/base/wheel_lag_s = -1: must be >= 0");
  expectComplaint("base/wheel_lags", 1.0, "wheel_lags: unknown");
  expectComplaint("base/wheel_radius_m", 0.0, "/base/wheel_radius_m = 0: must be > 0");
  expectComplaint("base/slip", "much", "must be a number");
  expectComplaint("cameras/rate_hz", -120.0, "rate_hz");
  expectComplaint("cameras/occlusion_probability", 2.0,
                  "occlusion_probability = 2: must be 0 ... 1");
  expectComplaint("natnet/version", "five", "/natnet/version = \"five\"");
  expectComplaint("natnet/up_axis", "x", "/natnet/up_axis = \"x\": must be one of y, z");
  expectComplaint("natnet/command_port", 70000,
                  "/natnet/command_port = 70000: must be 0 ... 65535");
  expectComplaint("truth_rate_hz", 0.0, "truth_rate_hz");
}

TEST(OptionsTest, BadFaultsAreNamed) {
  expectComplaint("faults", "lost", "must be a list");
  expectComplaint("faults", faultList("kind", "gone"), "faults[0]: fault kind 'gone'");
  expectComplaint("faults", faultList("at", 1.0), "at: unknown");
  expectComplaint("faults", faultList("at_s", "soon"), "at_s: must be a number");
  expectComplaint("faults", faultList("duration_s", -1.0), "duration_s");
  XmlRpc::XmlRpcValue robots;
  robots[0] = "robot_7";
  expectComplaint("faults", faultList("robots", robots), "robot_7");
  expectComplaint("faults", faultList("robots", "robot_0"), "robots: must be a list");
}

}  // namespace
}  // namespace sylph_sim

int main(int argc, char** argv) {
  ros::init(argc, argv, "options_test");
  testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle nh;  // keeps the node up
  return RUN_ALL_TESTS();
}
