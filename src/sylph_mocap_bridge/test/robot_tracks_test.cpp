#include "sylph_mocap_bridge/robot_tracks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sylph_mocap_bridge/body_names.hpp"
#include "sylph_mocap_bridge/rate_gate.hpp"

namespace sylph_mocap_bridge {
namespace {

TracksOptions twoRobots() {
  TracksOptions options;
  options.body_from_robot.resize(2);
  options.frozen_limit_s = 0.0;
  return options;
}

Measurement measuredAt(double time_s) {
  Measurement measurement;
  measurement.robot = 1;
  measurement.position_m = {1.0, 2.0, 0.1};
  measurement.time_s = time_s;
  measurement.stamp_s = time_s + 1000.0;
  return measurement;
}

TEST(RobotTracksTest, AGoodMeasurementIsAPoseWithItsStamp) {
  RobotTracks tracks(twoRobots());
  const auto state = tracks.update(measuredAt(1.0), 1001.01);
  ASSERT_TRUE(state);
  EXPECT_EQ(1U, state->robot);
  EXPECT_EQ(1001.0, state->stamp_s);
  EXPECT_TRUE(state->map_from_robot.position_m.isApprox(Eigen::Vector3d(1.0, 2.0, 0.1)));
  EXPECT_EQ(1U, tracks.counts()[1].good);
  EXPECT_NEAR(0.01, tracks.counts()[1].last_age_s, 1e-9);
}

TEST(RobotTracksTest, ABodyThatTheCamerasLostIsNoPose) {
  RobotTracks tracks(twoRobots());
  Measurement lost = measuredAt(1.0);
  lost.tracked = false;
  EXPECT_FALSE(tracks.update(lost, 1001.0));
  EXPECT_EQ(1U, tracks.counts()[1].untracked);
}

TEST(RobotTracksTest, WhatIsNoNumberIsNoPose) {
  RobotTracks tracks(twoRobots());
  Measurement malformed = measuredAt(1.0);
  malformed.position_m.x() = std::nan("");
  EXPECT_FALSE(tracks.update(malformed, 1001.0));
  malformed = measuredAt(1.0);
  malformed.orientation_xyzw.setZero();
  EXPECT_FALSE(tracks.update(malformed, 1001.0));
  malformed = measuredAt(std::nan(""));
  EXPECT_FALSE(tracks.update(malformed, 1001.0));
  EXPECT_EQ(2U, tracks.counts()[1].malformed);
  EXPECT_EQ(1U, tracks.counts()[1].unordered);
}

TEST(RobotTracksTest, StampsNeverGoBackNorRepeat) {
  RobotTracks tracks(twoRobots());
  EXPECT_TRUE(tracks.update(measuredAt(1.0), 1001.0));
  EXPECT_FALSE(tracks.update(measuredAt(1.0), 1001.0));
  EXPECT_FALSE(tracks.update(measuredAt(0.9), 1001.0));
  EXPECT_TRUE(tracks.update(measuredAt(1.1), 1001.1));
  EXPECT_EQ(2U, tracks.counts()[1].unordered);
}

TEST(RobotTracksTest, AnOldPoseIsNoPose) {
  TracksOptions options = twoRobots();
  options.largest_age_s = 0.3;
  RobotTracks tracks(options);
  EXPECT_FALSE(tracks.update(measuredAt(1.0), 1001.31));
  EXPECT_TRUE(tracks.update(measuredAt(1.0), 1001.29));
  EXPECT_EQ(1U, tracks.counts()[1].stale);
}

TEST(RobotTracksTest, APoseOfTheFutureIsNoPose) {
  TracksOptions options = twoRobots();
  options.largest_age_s = 0.3;
  RobotTracks tracks(options);
  EXPECT_FALSE(tracks.update(measuredAt(1.0), 1000.69));
  EXPECT_TRUE(tracks.update(measuredAt(1.0), 1000.71));
  EXPECT_EQ(1U, tracks.counts()[1].ahead);
}

TEST(RobotTracksTest, ADriverWithAnotherClockIsNamed) {
  RobotTracks tracks(twoRobots());
  const TrackCounts before = tracks.counts()[1];
  // Motive's ticks through VRPN: seconds since that computer was started.
  EXPECT_FALSE(tracks.update(measuredAt(1.0), 1.7e9));
  EXPECT_EQ(
      "is not seen: its stamps are 1.7e+09 s old: the clocks of two computers differ, or the "
      "driver stamps by another one",
      bodyProblem(tracks.counts()[1], before));
  EXPECT_FALSE(tracks.update(measuredAt(1.1), 998.1));
  EXPECT_FALSE(tracks.update(measuredAt(1.2), 998.2));
  EXPECT_EQ(
      "is not seen: its stamps are 3 s ahead: the clocks of two computers differ, or the driver "
      "stamps by another one",
      bodyProblem(tracks.counts()[1], before));
}

TEST(RobotTracksTest, APoseThatKeepsEachBitIsFrozen) {
  TracksOptions options = twoRobots();
  options.frozen_limit_s = 0.1;
  RobotTracks tracks(options);
  Measurement measurement = measuredAt(1.0);
  const auto comesAt = [&](double time_s) {
    measurement.time_s = time_s;
    measurement.stamp_s = time_s + 1000.0;
    return tracks.update(measurement, measurement.stamp_s).has_value();
  };
  EXPECT_TRUE(comesAt(1.0));
  EXPECT_TRUE(comesAt(1.09));
  EXPECT_FALSE(comesAt(1.11));
  measurement.position_m.x() += 1e-7;
  EXPECT_TRUE(comesAt(1.12));
  EXPECT_EQ(1U, tracks.counts()[1].frozen);
}

TEST(RobotTracksTest, TheProblemOfABodyIsNamed) {
  const TrackCounts before;
  TrackCounts now = before;
  EXPECT_EQ("is not seen: no data", bodyProblem(now, before));
  now.good = 96;
  now.untracked = 4;
  EXPECT_EQ("", bodyProblem(now, before));
  now.untracked = 20;
  now.unordered = 30;
  EXPECT_EQ("is lost at times: its stamps do not advance", bodyProblem(now, before));
  now.good = 0;
  now.frozen = 31;
  EXPECT_EQ("is not seen: its pose is frozen", bodyProblem(now, before));
}

TEST(RobotTracksTest, AfterARestartTimeMayBeginAnew) {
  RobotTracks tracks(twoRobots());
  EXPECT_TRUE(tracks.update(measuredAt(50.0), 1050.0));
  tracks.reset();
  EXPECT_TRUE(tracks.update(measuredAt(1.0), 1001.0));
}

TEST(RobotTracksTest, ABodyThatComesBackHasNoVelocityAtFirst) {
  RobotTracks tracks(twoRobots());
  double time_s = 1.0;
  for (int i = 0; i < 10; ++i, time_s += 0.01) {
    tracks.update(measuredAt(time_s), time_s + 1000.0);
  }
  const auto moving = tracks.update(measuredAt(time_s), time_s + 1000.0);
  ASSERT_TRUE(moving);
  EXPECT_TRUE(moving->velocity);
  time_s += 1.0;
  const auto back = tracks.update(measuredAt(time_s), time_s + 1000.0);
  ASSERT_TRUE(back);
  EXPECT_FALSE(back->velocity);
}

sylph_natnet::ModelDefinitions definitionsOf(
    const std::vector<std::pair<std::string, std::int32_t>>& bodies) {
  sylph_natnet::ModelDefinitions definitions;
  for (const auto& [name, id] : bodies) {
    sylph_natnet::RigidBodyDefinition body;
    body.name = name;
    body.id = id;
    definitions.rigid_bodies.push_back(body);
  }
  return definitions;
}

TEST(BodyNamesTest, NamesTellTheRobots) {
  BodyNames names({"red", "blue"});
  EXPECT_EQ((std::vector<std::string>{"red", "blue"}), names.missing());
  names.update(definitionsOf({{"blue", 5}, {"lamp", 6}, {"red", 7}}));
  EXPECT_EQ(1U, names.robotOf(5));
  EXPECT_EQ(0U, names.robotOf(7));
  EXPECT_FALSE(names.robotOf(6));
  EXPECT_TRUE(names.missing().empty());
  EXPECT_EQ(3U, names.offered().size());
}

TEST(BodyNamesTest, ARenamedBodyIsNotTheRobotAnyMore) {
  BodyNames names({"red", "blue"});
  names.update(definitionsOf({{"red", 1}, {"blue", 2}}));
  names.update(definitionsOf({{"red", 1}, {"green", 2}}));
  EXPECT_FALSE(names.robotOf(2));
  EXPECT_EQ(std::vector<std::string>{"blue"}, names.missing());
}

TEST(BodyNamesTest, ANameOrIdThatAppearsTwiceIsNobody) {
  BodyNames names({"red", "blue", "green"});
  names.update(definitionsOf({{"red", 1}, {"red", 2}, {"blue", 3}, {"lamp", 3}, {"green", 4}}));
  EXPECT_FALSE(names.robotOf(1));
  EXPECT_FALSE(names.robotOf(2));
  EXPECT_FALSE(names.robotOf(3));
  EXPECT_EQ(2U, names.robotOf(4));
  EXPECT_EQ((std::vector<std::string>{"red", "blue"}), names.ambiguous());
}

int countPassed(RateGate gate, double rate_hz, double begin_s, double duration_s) {
  int passed = 0;
  for (int i = 0; i < static_cast<int>(rate_hz * duration_s); ++i) {
    passed += gate.passes(begin_s + i / rate_hz) ? 1 : 0;
  }
  return passed;
}

TEST(RateGateTest, LetsThroughAtItsRate) {
  EXPECT_NEAR(600, countPassed(RateGate(60.0), 120.0, 1.7e9, 10.0), 2);
  EXPECT_NEAR(300, countPassed(RateGate(30.0), 100.0, 0.0, 10.0), 2);
  EXPECT_EQ(1200, countPassed(RateGate(0.0), 120.0, 1.7e9, 10.0));
  EXPECT_EQ(1000, countPassed(RateGate(120.0), 100.0, 5.0, 10.0));
}

TEST(RateGateTest, GoesOnAfterAPauseAndWhenTimeGoesBack) {
  RateGate gate(10.0);
  EXPECT_TRUE(gate.passes(100.0));
  EXPECT_FALSE(gate.passes(100.05));
  EXPECT_TRUE(gate.passes(200.0));
  EXPECT_FALSE(gate.passes(200.05));
  EXPECT_TRUE(gate.passes(1.0));
  EXPECT_FALSE(gate.passes(1.05));
}

}  // namespace
}  // namespace sylph_mocap_bridge
