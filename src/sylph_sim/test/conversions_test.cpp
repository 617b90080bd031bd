#include "sylph_sim/conversions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sylph_sim {
namespace {

CapturedFrame frameAt(double x_m, double y_m, double yaw_rad) {
  CapturedFrame frame{17, 1002.0, 1002.008, {}};
  frame.bodies.push_back({{x_m, y_m, yaw_rad}, true});
  frame.bodies.push_back({{0.0, 0.0, 0.0}, false});
  return frame;
}

TEST(ConversionsTest, WithZUpTheAxesAreThoseOfTheMap) {
  const sylph_natnet::Frame frame = toNatNet(frameAt(1.0, 2.0, M_PI / 2.0), 1000.0, UpAxis::Z, 0.1);
  const sylph_natnet::RigidBodySample& body = frame.rigid_bodies.at(0);
  EXPECT_EQ((std::array<float, 3>{1.0F, 2.0F, 0.1F}), body.position_m);
  EXPECT_NEAR(std::sin(M_PI / 4.0), body.orientation_xyzw[2], 1e-6);
  EXPECT_NEAR(std::cos(M_PI / 4.0), body.orientation_xyzw[3], 1e-6);
}

TEST(ConversionsTest, WithYUpTheMapsYPointsAgainstTheirZ) {
  const sylph_natnet::Frame frame = toNatNet(frameAt(1.0, 2.0, M_PI / 2.0), 1000.0, UpAxis::Y, 0.1);
  const sylph_natnet::RigidBodySample& body = frame.rigid_bodies.at(0);
  EXPECT_EQ((std::array<float, 3>{1.0F, 0.1F, -2.0F}), body.position_m);
  EXPECT_NEAR(std::sin(M_PI / 4.0), body.orientation_xyzw[1], 1e-6);
  EXPECT_EQ(0.0F, body.orientation_xyzw[2]);
}

TEST(ConversionsTest, TicksTellCaptureAndTransmissionInSimulatedTime) {
  const sylph_natnet::Frame frame = toNatNet(frameAt(0.0, 0.0, 0.0), 1000.0, UpAxis::Z, 0.1);
  EXPECT_EQ(17, frame.number);
  EXPECT_EQ(toTicks(2.0), frame.mid_exposure_ticks);
  EXPECT_EQ(toTicks(2.008), frame.transmit_ticks);
  EXPECT_EQ(80'000U, frame.transmit_ticks - frame.mid_exposure_ticks);
  EXPECT_GT(frame.data_received_ticks, frame.mid_exposure_ticks);
  EXPECT_LT(frame.data_received_ticks, frame.transmit_ticks);
}

TEST(ConversionsTest, BodiesHaveTheIdsOfTheirDefinitions) {
  sylph::Experiment experiment;
  experiment.robots.resize(2);
  experiment.robots[0].rigid_body = "first";
  experiment.robots[1].rigid_body = "second";
  const sylph_natnet::ModelDefinitions definitions = modelDefinitions(experiment);
  const sylph_natnet::Frame frame = toNatNet(frameAt(0.0, 0.0, 0.0), 1000.0, UpAxis::Z, 0.1);
  ASSERT_EQ(2U, definitions.rigid_bodies.size());
  EXPECT_EQ("second", definitions.rigid_bodies[1].name);
  for (std::size_t robot = 0; robot < 2; ++robot) {
    EXPECT_EQ(definitions.rigid_bodies[robot].id, frame.rigid_bodies[robot].id);
  }
  EXPECT_TRUE(frame.rigid_bodies[0].tracked);
  EXPECT_FALSE(frame.rigid_bodies[1].tracked);
}

TEST(ConversionsTest, AFaultOfAMessageHasItsKindsDefaults) {
  sylph::Experiment experiment;
  experiment.robots.resize(2);
  experiment.robots[0].name = "robot_0";
  experiment.robots[1].name = "robot_1";
  sylph_msgs::InjectFaultRequest request;
  request.kind = "jump";
  request.robots = {"robot_1"};
  request.delay_s = 0.5;
  const Fault whole_run = fromMessage(request, experiment);
  EXPECT_EQ(FaultKind::Jump, whole_run.kind);
  EXPECT_EQ(std::vector<std::size_t>{1}, whole_run.robots);
  EXPECT_EQ(0.5, whole_run.at_s);
  EXPECT_TRUE(std::isinf(whole_run.duration_s));
  EXPECT_EQ(0.1, whole_run.value);
  request.duration_s = 2.0;
  request.value = -0.3;
  const Fault short_one = fromMessage(request, experiment);
  EXPECT_EQ(2.0, short_one.duration_s);
  EXPECT_EQ(-0.3, short_one.value);
  request.robots = {"robot_7"};
  EXPECT_THROW(fromMessage(request, experiment), std::runtime_error);
}

}  // namespace
}  // namespace sylph_sim
